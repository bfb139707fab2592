// The code of the guide in JavaScript runs, and what it says is true. tools/snippets.py took it from the pages.
import assert from 'node:assert/strict';
import { readdir } from 'node:fs/promises';
import { test } from 'node:test';

const folder = new URL('node_modules/.guide/', import.meta.url);
const chapters = (await readdir(folder)).filter((name) => name.endsWith('.mjs'));

test('the chapters are there', () => assert.ok(chapters.length >= 8));
for (const name of chapters) test(`the code of ${name} does what the page says`, () => import(new URL(name, folder)));
