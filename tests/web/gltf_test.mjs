// What `prehend plan --export gltf` writes is glTF without a flaw, and says what grasps.json says.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import validator from 'gltf-validator';

const program = process.env.PREHEND_PROGRAM;
assert.ok(program, 'PREHEND_PROGRAM: must name the program');

const folder = mkdtempSync(join(tmpdir(), 'prehend_gltf_'));
after(() => rmSync(folder, { recursive: true }));

const kNastyName = '<script>alert(1)</script>';

// Writes a scene of the library, changed, and answers its file.
function changedScene(name, change) {
  const library = new URL(`../../benchmarks/scenes/${name}.json`, import.meta.url);
  const scene = JSON.parse(readFileSync(library, 'utf8'));
  change(scene);
  const file = join(folder, `${name}_changed.json`);
  writeFileSync(file, JSON.stringify(scene));
  return file;
}

function plan(scene, out) {
  const words = ['plan', scene, '--top', '2', '--export', 'gltf', '--out', out];
  execFileSync(program, words, { stdio: ['ignore', 'ignore', 'inherit'] });
  return JSON.parse(readFileSync(join(out, 'grasps.json'), 'utf8'));
}

async function validate(bytes) {
  const report = await validator.validateBytes(new Uint8Array(bytes), { format: 'glb', maxIssues: 0 });
  return report.issues;
}

async function expectValid(bytes, name) {
  const issues = await validate(bytes);
  const listed = JSON.stringify(issues.messages.filter((message) => message.severity < 2), null, 1);
  assert.equal(issues.numErrors, 0, `${name}: ${listed}`);
  assert.equal(issues.numWarnings, 0, `${name}: ${listed}`);
}

// The nodes of a file by name, and its root.
function nodesOf(bytes) {
  const { nodes, scenes } = JSON.parse(bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12)));
  return { names: nodes.map((node) => node.name), root: nodes[scenes[0].nodes[0]] };
}

// Plans a scene and looks at all its files; `names` are of nodes that each must have.
async function checkScene(scene, names) {
  const out = mkdtempSync(join(folder, 'out_'));
  const { grasps } = plan(scene, out);
  assert.equal(grasps.length, 2);
  const files = readdirSync(out).filter((file) => file.endsWith('.glb')).sort();
  assert.deepEqual(files, ['grasp_1.glb', 'grasp_2.glb']);
  for (const [index, file] of files.entries()) {
    const bytes = readFileSync(join(out, file));
    await expectValid(bytes, file);
    const nodes = nodesOf(bytes);
    for (const name of names) assert.ok(nodes.names.includes(name), `${file}: no node ${name}`);
    const { outcome, epsilon, volume } = grasps[index];
    assert.deepEqual(nodes.root.extras, { rank: index + 1, outcome, epsilon, volume });

    // The validator looks at the data as well.
    bytes.fill(0x7f, bytes.length - 64);
    assert.notEqual((await validate(bytes)).numErrors, 0);
  }
}

test('a free hand', () => checkScene('mug', ['mug', 'palm', 'contact', 'weakest force']));

test('a hand on an arm', () =>
  checkScene('mug_on_table', ['mug', 'palm', 'table', 'floor', 'arm/forearm', 'weakest torque']));

test('names that would be markup', () => {
  const scene = changedScene('mug_on_table', (changed) => {
    changed.object.name = kNastyName;
    changed.obstacles[0].name = `"${kNastyName}`;
  });
  return checkScene(scene, [kNastyName, `"${kNastyName}`]);
});
