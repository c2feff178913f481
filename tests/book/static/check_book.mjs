// node check_book.mjs BOOK_FOLDER WARNINGS_FILE MACHINE_PATH...
// Prints every fault of the book; fails if there is one, or a warning of Doxygen's.
import {readFileSync} from 'node:fs';
import {faults} from './rules.mjs';
import {read_book} from './page.mjs';

const [folder, warnings_file, ...machine_paths] = process.argv.slice(2);
const book = read_book(folder, machine_paths);
const warnings = readFileSync(warnings_file, 'utf8').split('\n').filter(line => line.trim());
const found = faults(book);

for (const warning of warnings) console.log(`Doxygen warns: ${warning}`);
for (const {rule, path, line, problem} of found) console.log(`${path}:${line}: ${problem} (${rule})`);
console.log(`${book.pages.size} pages, ${warnings.length} warnings, ${found.length} faults`);
if (book.pages.size === 0) console.log(`There is no page in ${folder}.`);
process.exitCode = warnings.length || found.length || book.pages.size === 0 ? 1 : 0;
