// How this copy of the book came about: node colophon.mjs SETTINGS.json
import {execFileSync} from 'node:child_process';
import {createRequire} from 'node:module';
import {cpus} from 'node:os';
import {existsSync, mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {named} from './fonts.mjs';

const settings = JSON.parse(readFileSync(process.argv[2], 'utf8'));

function told_by(program, ...options) {
  try {
    return execFileSync(program, options, {
      cwd: settings.source,
      encoding: 'utf8',
      stdio: ['ignore', 'pipe', 'ignore'],
    }).trim();
  } catch {
    return '';
  }
}

function commit() {
  const name = told_by('git', 'rev-parse', '--short=12', 'HEAD');
  // Inside somebody else's folder git would name a commit that knows nothing of this one.
  if (!name || !told_by('git', 'ls-tree', '--name-only', 'HEAD')) return 'none: this copy was built outside git';
  return told_by('git', 'status', '--porcelain') ? `${name}, modified` : name;
}

function operating_system() {
  if (!existsSync('/etc/os-release')) return told_by('uname', '-sr');
  return /^PRETTY_NAME="?([^"\n]*)/m.exec(readFileSync('/etc/os-release', 'utf8'))?.[1] ?? told_by('uname', '-sr');
}

const require = createRequire(import.meta.url);
const tidy = flags => [...new Set(flags.split(/\s+/).filter(Boolean))].join(' ');
const values = {
  compiler: settings.compiler,
  check_flags: tidy(settings.check_flags),
  program_flags: tidy(settings.program_flags),
  commit: commit(),
  machine: `${cpus()[0]?.model.trim() ?? 'an unknown processor'}, ${cpus().length} cores`,
  measurements: settings.measurements,
  operating_system: operating_system(),
  cmake: settings.cmake,
  doxygen: told_by(settings.doxygen, '--version'),
  node: process.versions.node,
  katex: require(join(settings.katex, 'katex.js')).version,
  fonts: named(settings.fonts),
  gnuplot: told_by(settings.gnuplot, '--version').replace('gnuplot ', '').replace(' patchlevel ', '.'),
};

const old = existsSync(settings.colophon) ? JSON.parse(readFileSync(settings.colophon, 'utf8')) : {};
if (JSON.stringify({...old, date: undefined}) !== JSON.stringify({...values, date: undefined})) {
  mkdirSync(dirname(settings.colophon), {recursive: true});
  writeFileSync(settings.colophon, JSON.stringify({...values, date: new Date().toISOString().slice(0, 10)}));
}
