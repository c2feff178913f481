// Questions with a place to answer, and the gates before what answers them.
import {escape} from './text.mjs';

/**
 * Choices, or "number UNIT"; what happens is folded until the reader has chosen. The name is the browser's key, once in the book. The
 * choices are no group of the browser's: in one the arrow keys would answer on their way to the next, so predict.js keeps them to one.
 */
export function prediction(name, question, choices, answer) {
  const [, unit] = /^number ?(.*)$/.exec(choices.join(';')) ?? [];
  const inputs = unit !== undefined
    ? [`<label><input type="number" inputmode="decimal" step="any" data-unit="${escape(unit)}"> ${escape(unit)} <button>Answer</button></label>`]
    : choices.map(choice => `<label><input type="radio" value="${escape(choice)}"> ${escape(choice)}</label>`);
  return `<form class="prediction unindexed" id="predict_${name}" data-prediction="${name}">` +
    `<fieldset><legend>${escape(question)}</legend>${inputs.join('')}</fieldset>` +
    `<details class="fold"><summary>What happens</summary><p>${escape(answer)}</p></details></form>`;
}

/** [opening, closing] of what answers the prediction: shut by the script alone, so that it is open without, and in no search. */
export function gate(name, question, is_near) {
  const asked = is_near ? '' : `: <i>${escape(question)}</i>`;
  const guess = '<p class="on-paper guess">Guess before you read on. The <a class="elsewhere" href="#answers_of_page">answer</a> stands upside down.</p>';
  return [
    `<div class="gate${is_near ? '' : ' far'} unindexed" data-gate="${name}">${is_near ? guess : ''}<p class="shut"><a href="#predict_${name}">Answer first</a>${asked || ', then look.'} ` +
      '<button type="button">Just show me</button></p><div class="gated" tabindex="-1">',
    '</div></div>',
  ];
}

/** For paper, where nothing folds: what happens, at the end of the page that is called `name`. */
export function answers(name, predictions) {
  const told = predictions.map(({question, answer}) => `<li>${escape(question)} <b>${escape(answer)}</b></li>`);
  return `<div class="on-paper answers unindexed" id="answers_of_page"><p><b>Answers to ${escape(name)}</b></p><ol>${told.join('')}</ol></div>`;
}
