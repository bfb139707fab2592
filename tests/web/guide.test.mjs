// Runs the JavaScript code of the guide, and checks its claims. tools/snippets.py extracts the code from the pages.
import assert from 'node:assert/strict';
import { readdir } from 'node:fs/promises';
import { test } from 'node:test';

const folder = new URL('node_modules/.guide/', import.meta.url);
const chapters = (await readdir(folder)).filter((name) => name.endsWith('.mjs'));

test('the code of all chapters was extracted', () => assert.ok(chapters.length >= 8));
for (const name of chapters) test(`the code of ${name} does what the page says`, () => import(new URL(name, folder)));
