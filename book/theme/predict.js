// Places to answer before the page does: what a reader predicted is kept in the browser, shown beside what happens, and opens the
// gates before what answers it.
(() => {
  const open_gates = name => {
    for (const gate of document.querySelectorAll(`[data-gate="${name}"]`)) gate.classList.add('open');
  };

  /** The browser's memory, if it keeps one. */
  const recall = key => {
    try {
      return localStorage.getItem(key);
    } catch {
      return null;
    }
  };
  const remember = (key, text) => {
    try {
      localStorage.setItem(key, text);
    } catch { /* a browser that keeps nothing */ }
  };
  const button = (text, act) => Object.assign(document.createElement('button'), {type: 'button', textContent: text, onclick: act});

  const never = 'tumble.never-ask';
  const forms = [...document.querySelectorAll('form.prediction')];
  function never_ask() {
    remember(never, 'yes');
    for (const form of forms) form.dispatchEvent(new Event('shown'));
    offer_questions();
  }
  function ask_again() {
    for (const key of Object.keys(localStorage)) if (key === never || (key.startsWith('tumble.prediction.') && !recall(key))) localStorage.removeItem(key);
    location.reload();
  }
  /** Who reads without questions can have them back. */
  function offer_questions() {
    forms[0]?.append(button('Ask me again', ask_again));
  }

  function keep_prediction(form) {
    const name = form.dataset.prediction,
      key = `tumble.prediction.${name}`;
    const fold = form.querySelector('details');
    const said = document.createElement('p');
    said.className = 'predicted';
    said.setAttribute('role', 'status');
    fold.before(said);
    const choices = [...form.querySelectorAll('input[type="radio"]')];
    const show = text => {
      for (const choice of choices) choice.checked = choice.value === text;
      said.textContent = text ? `You predicted: ${text}. Now look.` : '';
      form.classList.add('answered');
      fold.open = true;
      open_gates(name);
    };
    const keep = text => {
      remember(key, text);
      show(text);
      dispatchEvent(new Event('predicted')); // a figure draws the guess
    };
    const kept = recall(key); // null until the reader answers; empty for one who only wants to see
    if (kept !== null) show(kept);
    else if (recall(never)) keep('');
    form.addEventListener('shown', () => {
      if (recall(key) === null) keep('');
    });
    for (const input of form.querySelectorAll('input')) {
      if (input.type !== 'radio') input.value = (kept ?? '').split(' ')[0];
      input.addEventListener('change', () => {
        if (input.value) keep(input.type === 'radio' ? input.value : `${input.value} ${input.dataset.unit}`.trim());
      });
    }
    form.addEventListener('submit', event => event.preventDefault());
    for (const gate of document.querySelectorAll(`[data-gate="${name}"]`))
      gate.querySelector('.shut button').addEventListener('click', () => {
        keep('');
        gate.querySelector('.gated').focus({preventScroll: true}); // the button is gone
      });
  }

  /** A link to what stands behind a gate opens it, for this visit. */
  function follow_address() {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)).split('?')[0]);
    const gate = target?.closest('.gate:not(.open)');
    if (!gate) return;
    open_gates(gate.dataset.gate);
    target.scrollIntoView();
  }

  for (const form of forms) keep_prediction(form);
  if (recall(never)) offer_questions();
  else document.querySelector('.gate .shut')?.append(' ', button('Never ask', never_ask));
  addEventListener('hashchange', follow_address);
  follow_address();
})();
