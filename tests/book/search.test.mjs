// Seventy-two questions as readers ask them, and where each must lead first. TUMBLE_BOOK is the folder of the book.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {runInThisContext} from 'node:vm';
import '../../book/theme/search_ranking.js';

globalThis.window = globalThis;
runInThisContext(readFileSync(join(process.env.TUMBLE_BOOK, 'search_index.js'), 'utf8'));
const {bookIndex, book_search} = globalThis;
const prepared = book_search.prepare(bookIndex.documents, bookIndex.same);
const first = question => book_search.find(question, prepared).hits.slice(0, 3).map(({document}) => document.address);

const questions = [
  // What nobody found, or found late.
  ['slerp', /chapter_10_fixed_timestep\.html#timestep_draw|interpolation_8hpp/],
  ['why does my object spin forever', /chapter_09_damping/],
  ['center of mass', /chapter_0[123]_|gallery/],
  ['inverse inertia tensor world space', /chapter_05_rigid_body\.html#rigid_body_tensor/],
  ['gyroscopic', /chapter_08_tumbling\.html#tumbling_euler/],
  ['moment of inertia of a box', /shapes\.html#inertia_code_solids/],
  ['energy drift', /chapter_06_semi_implicit_euler/],
  ['energy drift over time', /chapter_06_semi_implicit_euler\.html#euler_spring/],
  ['quaternion integration', /chapter_07_orientation\.html#the_exponential/],
  ['units', /conventions\.html#conventions_units/],
  ['dt', /conventions\.html#conventions_symbols|chapter_10_fixed_timestep/],
  ['NaN', /gallery\.html#gallery_nan|chapter_11_world/],
  ['gimbal lock', /chapter_04_quaternions\.html#which_numbers/],
  ['my quaternion drifts', /chapter_07_orientation\.html#without_normalising/],
  ['how do I add my own force', /effects\.html#effects_own/],
  ['float or double', /conventions\.html#conventions_precision/],
  ['timestep for a stiff spring', /how_long_may_a_step_be|step_limits/],
  ['nlerp', /chapter_10_fixed_timestep\.html#timestep_draw/],
  ['skip_reason', /effects\.html#effects_members/],
  ['collision', /effects\.html#effects_forms/],
  ['collisions between bodies', /effects\.html#effects_forms/],
  ['FetchContent', /reference\.html#reference_link/],
  ['RK45', /reference\.html#task_own_step/],
  ['half extents', /solids_8hpp\.html#box/],
  ['glossary', /conventions\.html#conventions_words/],
  ['what does step throw', /reference\.html#task_errors/],
  ['forms.hpp', /forms_8hpp/],
  ['box falls through the floor', /effects\.html#effects_forms/],
  ['rotation matrix from quaternion', /chapter_04_quaternions\.html#into_and_out_of_a_matrix/],
  ['exact solution free rigid body', /reference\.html#task_exact/],
  // Headings.
  ['parallel axis', /chapter_03_inertia\.html#inertia_parallel/],
  ['parallel axes theorem', /chapter_03_inertia\.html#inertia_parallel/],
  ['principal axes', /shapes\.html#inertia_code_principal/],
  ['forgotten clear', /chapter_01_force\.html#the_forgotten_clear/],
  ['couple', /chapter_02_torque\.html#couples/],
  ['spiral of death', /chapter_10_fixed_timestep\.html#the_spiral_of_death/],
  ['exponential and logarithm', /chapter_04_quaternions\.html#exponential_and_logarithm/],
  ['arc cosine', /chapter_04_quaternions\.html#the_arc_cosine/],
  ['degrees or radians', /conventions\.html#conventions_units|chapter_04_quaternions\.html#degrees_for_radians/],
  ['without normalising', /chapter_07_orientation\.html#without_normalising/],
  ['drag that explodes', /chapter_09_damping\.html#drag_that_explodes/],
  ['how long until the next flip', /chapter_08_tumbling\.html#tumbling_wait/],
  ['frames and axes', /conventions\.html#conventions_frames/],
  ['precision', /conventions\.html#conventions_precision/],
  // Words of other books and engines.
  ['dzhanibekov effect', /chapter_08_tumbling/],
  ['tennis racket theorem', /chapter_08_tumbling/],
  ['steiner', /chapter_03_inertia\.html#inertia_parallel/],
  ['quaternion multiplication order', /chapter_04_quaternions/],
  ['symplectic integrator', /chapter_06_semi_implicit_euler/],
  ['euler angles', /chapter_04_quaternions\.html#which_numbers/],
  ['air resistance', /chapter_09_damping|effects/],
  ['variable timestep', /chapter_10_fixed_timestep/],
  ['euler equations', /chapter_08_tumbling\.html#tumbling_euler|euler__equations/],
  ['unit roundoff', /how_to_read\.html#read_checks|conventions/],
  // Names in code, and keys of scene files.
  ['apply_impulse_at', /rigid__body_8hpp\.html#/],
  ['make_rigid_body', /make__rigid__body_8hpp\.html|chapter_05_rigid_body\.html#rigid_body_make/],
  ['turn_by_splitting', /splitting_8hpp\.html#|chapter_08_tumbling/],
  ['spring_between', /scene_keys\.html#spring_between/],
  ['World', /^world_8hpp\.html#world$/],
  ['Mesh', /^mesh_8hpp\.html#mesh$/],
  ['Top', /^top_8hpp\.html#top$/],
  ['Scheme', /^scheme_8hpp\.html#/],
  ['World::step', /^world_8hpp\.html#world-/],
  ['world.step()', /^world_8hpp\.html#world-/],
  ['tumble::make_rigid_body', /^make__rigid__body_8hpp\.html#/],
  ['use_threads', /^in__packs_8hpp\.html#/],
  ['inverse_mass', /^particle_8hpp\.html#particle-/],
  // What one does with other engines.
  ['create a body', /^reference\.html#task_add/],
  ['get position', /^reference\.html#task_get/],
  ['step the simulation', /^reference\.html#task_world/],
  ['joint', /^reference\.html#task_spring/],
  ['exercise moon', /chapter_01_force\.html#exercise_moon|exercises/],
];

for (const [question, place] of questions) {
  test(`"${question}" leads to the right place first.`, () => {
    const found = first(question);
    assert.match(found[0] ?? 'nowhere', place, `it leads to ${found.join(', then ') || 'nowhere'}`);
  });
}

test('Words foreseen for a place lead there first.', () => {
  for (const {address, asked = []} of bookIndex.documents) for (const question of asked) assert.equal(first(question)[0], address, question);
});

test('There are seventy-two questions.', () => assert.equal(questions.length, 72));

test('Where no place holds every word, the best for some of them comes, and the reader is told.', () => {
  const {hits, whole} = book_search.find('quaternion xylophone', prepared);
  assert.equal(whole, false);
  assert.match(hits[0].document.address, /quaternion/);
});

test('A plain word that is the name of a function too leads to that second.', () => {
  for (const [word, place] of [['rotate', /^quaternion_8hpp/], ['add force', /^force_8hpp/], ['set step length', /^world_8hpp/]])
    assert.match(first(word)[1], place, word);
});

test('A word that the book lacks is taken for one of its words that differs by one letter, or for its own parts, and no other is.', () => {
  const {respelt} = book_search;
  for (const [wrong, right] of [['quaternon', 'quaternion'], ['quaternian', 'quaternion'], ['intertia', 'inertia'], ['qauternion', 'quaternion'], ['tumblling box', 'tumbling box'], ['setGravity', 'set gravity']])
    assert.equal(respelt(wrong, prepared), right);
  for (const other of ['quaternion', 'xylophone']) assert.equal(respelt(other, prepared), undefined);
});

test('What is nowhere in the book is found nowhere.', () => {
  assert.deepEqual(book_search.find('xylophone quartet', prepared).hits, []);
});

test('The forms of a word share a stem, and other words do not.', () => {
  for (const forms of [['turn', 'turns', 'turned', 'turning'], ['axis', 'axes'], ['damping', 'damped', 'damp'], ['rotation', 'rotate', 'rotating']])
    assert.equal(new Set(forms.map(book_search.stem)).size, 1, forms.map(book_search.stem).join());
  for (const [one, other] of [['force', 'form'], ['step', 'stem'], ['mass', 'mask']])
    assert.notEqual(book_search.stem(one), book_search.stem(other));
});
