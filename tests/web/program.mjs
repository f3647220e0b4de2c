// Runs the program on scenes, in a folder that is gone afterwards.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after} from 'node:test';

const program = process.env.PREHEND_PROGRAM;
assert.ok(program, 'PREHEND_PROGRAM: must name the program');

export const folder = mkdtempSync(join(tmpdir(), 'prehend_web_'));
after(() => rmSync(folder, {recursive: true}));

export const nastyName = '<script>alert(1)</script>';

// Writes a scene of the library, changed, and answers its file.
export function changedScene(name, change) {
  const library = new URL(`../../benchmarks/scenes/${name}.json`, import.meta.url);
  const scene = JSON.parse(readFileSync(library, 'utf8'));
  change(scene);
  const file = join(folder, `${name}_changed.json`);
  writeFileSync(file, JSON.stringify(scene));
  return file;
}

// Answers the folder that the run wrote to.
export function run(...words) {
  const out = mkdtempSync(join(folder, 'out_'));
  execFileSync(program, [...words, '--out', out], {stdio: 'ignore'});
  return out;
}

export function jsonOf(file) {
  return JSON.parse(readFileSync(file, 'utf8'));
}
