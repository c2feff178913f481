// Dark or light, before anything is drawn: as the reader chose last, or else as the system has it.
(() => {
  const name = 'tumble-dark';
  const system = window.matchMedia('(prefers-color-scheme: dark)');
  let chosen; // for this page alone, where the browser keeps nothing
  const choice = () => {
    try {
      return localStorage.getItem(name) ?? chosen;
    } catch {
      return chosen;
    }
  };
  const is_dark = () => (choice() ?? String(system.matches)) === 'true';
  const show = () => {
    document.documentElement.classList.toggle('dark-mode', is_dark());
    document.documentElement.classList.toggle('light-mode', !is_dark());
    document.getElementById('dark')?.setAttribute('aria-pressed', String(is_dark()));
  };
  show();
  system.addEventListener('change', show);
  window.addEventListener('storage', show);
  document.addEventListener('DOMContentLoaded', () => {
    show();
    document.getElementById('dark').addEventListener('click', () => {
      chosen = String(!is_dark());
      try {
        // What the system has as well is no choice of its own.
        if (chosen === String(system.matches)) localStorage.removeItem(name);
        else localStorage.setItem(name, chosen);
      } catch {
        // It holds until the page is left.
      }
      show();
    });
  });
})();
