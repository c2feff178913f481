// The player: its files for the book, and what stands on a page where a recording is replayed.
import {readFileSync, readdirSync} from 'node:fs';
import {join} from 'node:path';
import '../player/vectors.js';
import '../player/solids.js';
import '../player/camera.js';
import '../player/scene.js';
import '../player/still.js';
import {BookError} from './results.mjs';
import {escape} from './text.mjs';

const {scenes_of, stills_of} = globalThis.tumble_player;

/** The light colours of the book's style sheet, as the player wants them. */
export function light_palette(source) {
  const style = readFileSync(join(source, 'book/theme/book.css'), 'utf8');
  const colour = name => {
    const [, red, green, blue] = new RegExp(`--${name}: #(..)(..)(..);`).exec(style);
    return [red, green, blue].map(component => parseInt(component, 16));
  };
  return {
    paper: colour('figure-paper'),
    ink: colour('figure-frame'),
    grid: colour('figure-grid'),
    shade: [12, 26, 38],
    bodies: [1, 2, 3, 4, 5, 6].map(n => colour(`figure-${n}`)),
  };
}

/** {script, style}: the player's files, each kind as one. */
export function player_files(source) {
  const folder = join(source, 'book/player');
  const joined = ending =>
    readdirSync(folder)
      .filter(name => name.endsWith(ending))
      .sort()
      .map(name => readFileSync(join(folder, name), 'utf8'))
      .join('\n');
  return {script: joined('.js'), style: joined('.css')};
}

/** A title of one letter tells apart what stands side by side, and says nothing of what stands alone. */
function view(scene, text, still, is_alone) {
  return (
    `<div class="player-view">${scene.recording.title.length > 1 || !is_alone ? `<p class="player-title">${escape(scene.recording.title)}</p>` : ''}${still}` +
    `<script type="application/json" class="player-recording">${text.trim().replace(/</g, '\\u003c')}</script></div>`
  );
}

/** `recordings` are {name, text}; those side by side share one set of controls. `says` tells what one sees. */
export function player(recordings, says, source) {
  let views;
  try {
    const scenes = scenes_of(recordings.map(({text}) => JSON.parse(text)), 16);
    const stills = stills_of(scenes, light_palette(source));
    views = recordings.map(({text}, n) => view(scenes[n], text, stills[n], recordings.length === 1));
  } catch (error) {
    const names = recordings.map(({name}) => `"${name}"`).join(' and ');
    throw new BookError(`the recording ${names} cannot be replayed: ${error.message}`);
  }
  return (
    `<figure class="player unindexed" data-recording="${recordings[0].name}"><div class="player-views" role="img" aria-label="${escape(says)}">` +
    `${views.join('')}</div></figure>`
  );
}
