// The first pages of the real book need the results of the first chapters alone, and of the handles on the landing page: in a fresh
// copy there are no others yet. TUMBLE_BOOK_WORK is the folder in which the book was made.
import assert from 'node:assert/strict';
import {cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync, readdirSync} from 'node:fs';
import {spawnSync} from 'node:child_process';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {test} from 'node:test';

test('The first pages are set from the results of chapters 1 to 3 and of the handles.', () => {
  const made = process.env.TUMBLE_BOOK_WORK, scratch = mkdtempSync(join(tmpdir(), 'first_pages_'));
  try {
    const settings = JSON.parse(readFileSync(join(made, 'settings.json'), 'utf8'));
    const results = join(scratch, 'results'), first = ['01_force', '02_torque', '03_inertia'], handles = join(results, '08_tumbling');
    mkdirSync(handles, {recursive: true});
    for (const chapter of first) symlinkSync(join(settings.results, chapter), join(results, chapter));
    for (const name of readdirSync(join(settings.results, '08_tumbling')).filter(file => file.startsWith('t_handle')))
      cpSync(join(settings.results, '08_tumbling', name), join(handles, name));
    writeFileSync(join(scratch, 'Doxyfile'), readFileSync(settings.doxyfile, 'utf8').replaceAll(made, scratch));
    Object.assign(settings, {work: scratch, folder: join(scratch, 'book'), results, doxyfile: join(scratch, 'Doxyfile')});
    writeFileSync(join(scratch, 'settings.json'), JSON.stringify(settings));
    const {status, stderr} = spawnSync(process.execPath, [join(settings.source, 'book/tools/book.mjs'), join(scratch, 'settings.json'),
      '--so-far', first.join(',')], {encoding: 'utf8', timeout: 120_000});
    assert.equal(status, 0, stderr);
    const page = name => readFileSync(join(scratch, 'book', `${name}.html`), 'utf8');
    assert.match(page('chapter_11_world'), /This page is being made/);
    assert.doesNotMatch(page('index') + page('chapter_03_inertia'), /This page is being made/);
  } finally {
    rmSync(scratch, {recursive: true, force: true});
  }
});
