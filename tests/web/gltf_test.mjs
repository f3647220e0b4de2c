// What `prehend plan --export gltf` and `prehend replay --gltf` write is glTF without a flaw, and
// says what grasps.json and the session say.
import validator from 'gltf-validator';
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';

import {changedScene, folder, jsonOf, nastyName, run} from './program.mjs';

async function validate(bytes) {
  const report =
      await validator.validateBytes(new Uint8Array(bytes), {format: 'glb', maxIssues: 0});
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
  const {nodes, scenes} = JSON.parse(bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12)));
  return {names: nodes.map((node) => node.name), root: nodes[scenes[0].nodes[0]]};
}

// Plans a scene and looks at all its files; `names` are of nodes that each must have.
async function checkScene(scene, names) {
  const out = run('plan', scene, '--top', '2', '--export', 'gltf', '--no-report');
  const {grasps} = jsonOf(join(out, 'grasps.json'));
  assert.equal(grasps.length, 2);
  const files = readdirSync(out).filter((file) => file.endsWith('.glb')).sort();
  assert.deepEqual(files, ['grasp_1.glb', 'grasp_2.glb']);
  for (const [index, file] of files.entries()) {
    const bytes = readFileSync(join(out, file));
    await expectValid(bytes, file);
    const nodes = nodesOf(bytes);
    for (const name of names) assert.ok(nodes.names.includes(name), `${file}: no node ${name}`);
    const {outcome, epsilon, volume} = grasps[index];
    assert.deepEqual(nodes.root.extras, {rank: index + 1, outcome, epsilon, volume});

    // The validator looks at the data as well.
    bytes.fill(0x7f, bytes.length - 64);
    assert.notEqual((await validate(bytes)).numErrors, 0);
  }
}

test('a free hand', () => checkScene('mug', ['mug', 'palm', 'contact', 'weakest force']));

test('a hand on an arm', () => checkScene('mug_on_table', [
                           'mug', 'palm', 'table', 'floor', 'arm/forearm', 'weakest torque'
                         ]));

test('names that would be markup', () => {
  const scene = changedScene('mug_on_table', (changed) => {
    changed.object.name = nastyName;
    changed.obstacles[0].name = `"${nastyName}`;
  });
  return checkScene(scene, [nastyName, `"${nastyName}`]);
});

test('a recorded session', async () => {
  const X_world_hand = {position: [0.5, -0.6, 0.9], quaternion_wxyz: [0.6, 0, 0.8, 0]};
  const commands = [
    {command: 'scene.load', scene: 'mug_on_table'}, {command: 'hand.move', X_world_hand},
    {command: 'object.change', name: nastyName}, {command: 'hand.choose', hand: 'parallel_jaw'},
    {command: 'hand.dofs', dof: 'left', value: 0.01}, {command: 'undo'}, {command: 'undo'}
  ];
  const recording = join(folder, 'session.jsonl');
  writeFileSync(recording, commands.map((command) => JSON.stringify(command) + '\n').join(''));
  const file = join(folder, 'session.glb');
  execFileSync(
      process.env.PREHEND_PROGRAM,
      ['replay', recording, '--out', join(folder, 'replay.json'), '--gltf', file],
      {stdio: 'ignore'});
  for (const reply of jsonOf(join(folder, 'replay.json')).replies) {
    assert.ok(reply.ok, JSON.stringify(reply));
  }
  const bytes = readFileSync(file);
  await expectValid(bytes, 'session.glb');
  const {names} = nodesOf(bytes);
  for (const name of ['mug', nastyName, 'palm', 'table', 'arm/forearm', 'parallel_jaw']) {
    assert.ok(names.includes(name), `no node ${name}`);
  }
  const {info} =
      await validator.validateBytes(new Uint8Array(bytes), {format: 'glb', maxIssues: 0});
  assert.equal(info.animationCount, 1);

  // The validator looks at the keys as well: the last numbers of the file are of an animation.
  bytes.fill(0x7f, bytes.length - 64);
  assert.notEqual((await validate(bytes)).numErrors, 0);
});
