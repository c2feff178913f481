// Places to answer before the page does: what a reader predicted is kept in the browser, and shown beside what happens.
(() => {
  function keep_prediction(form) {
    const key = `tumble.prediction.${form.dataset.prediction}`;
    const fold = form.querySelector('details');
    const said = document.createElement('p');
    said.className = 'predicted';
    said.setAttribute('role', 'status');
    fold.querySelector('summary').after(said);
    const show = text => {
      said.textContent = text ? `You predicted: ${text}` : '';
    };
    const keep = text => {
      try {
        localStorage.setItem(key, text);
      } catch { /* a browser that keeps nothing */ }
      show(text);
      fold.open = true;
    };
    let kept = '';
    try {
      kept = localStorage.getItem(key) ?? '';
    } catch { /* as above */ }
    show(kept);
    for (const input of form.querySelectorAll('input')) {
      if (input.type === 'radio') input.checked = input.value === kept;
      else input.value = kept.split(' ')[0];
      input.addEventListener('change', () => keep(input.type === 'radio' ? input.value : `${input.value} ${input.dataset.unit}`.trim()));
    }
    form.addEventListener('submit', event => event.preventDefault());
  }

  for (const form of document.querySelectorAll('form.prediction')) keep_prediction(form);
})();
