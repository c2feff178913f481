// Questions with a place to answer, before the page answers them.
import {escape} from './text.mjs';

/** Choices, or "number UNIT"; what happens is folded until the reader has chosen. The name is the browser's key, once in the book. */
export function prediction(name, question, choices, answer) {
  const [, unit] = /^number ?(.*)$/.exec(choices.join(';')) ?? [];
  const inputs = unit !== undefined
    ? [`<label><input type="number" step="any" data-unit="${escape(unit)}"> ${escape(unit)}</label>`]
    : choices.map(choice => `<label><input type="radio" name="${name}" value="${escape(choice)}"> ${escape(choice)}</label>`);
  return `<form class="prediction unindexed" data-prediction="${name}"><fieldset><legend>${escape(question)}</legend>${inputs.join('')}</fieldset>` +
    `<details class="fold"><summary>What happens</summary><p>${escape(answer)}</p></details></form>`;
}
