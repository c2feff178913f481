// Every <figure class="live"> of a page comes to life as soon as it comes near: its module and its drawing are loaded by
// a script tag, since a page opened from a file may not fetch. The figure gets a property `live` with what a script may
// want: values, texts, set({knob: value}), seek(seconds), columns, and panels, each with its canvas.
//
// What describes a figure may have, beside panels and knobs: attach(figure), which adds parts of its own to the page;
// took(figure), after each run; refused(figure), where a run was not to be had; reset(figure), when a reader goes back to the
// start; progress(figure, said), while a run goes on; and changed(figure, changes), which makes texts of changes that are
// neither knobs nor texts. duration(run) is how much time it plays, speed(run) how much of it in a second, and clock(state)
// says the moment in words. A knob may have `also`, what else is set where a reader turns it. A panel may have drag(), or
// press(picture, at, state) for what is only pressed, and key(), each of which says what changes.
(() => {
  if (typeof document === 'undefined') return; // node draws stills only
  const live = globalThis.tumble_live, player = globalThis.tumble_player;

  function make(tag, properties = {}, attributes = {}, children = []) {
    const element = Object.assign(document.createElement(tag), properties);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
  }

  const button = (text, action, attributes = {}) => make('button', {type: 'button', textContent: text, onclick: action}, attributes);
  const steps = 400; // of a slider
  const work_of_a_frame = 3; // ms

  /** Asked between the parts of a long work: waits for the next picture where this one's time is up. */
  function frame_by_frame() {
    let began = performance.now();
    return async () => {
      if (performance.now() - began < work_of_a_frame) return true;
      await new Promise(done => { requestAnimationFrame(done); });
      began = performance.now();
      return true;
    };
  }

  /** Words with their symbols, which stand between stars, in italics, as a page has them; or, in a list of choices, bare. */
  const with_symbols = words => words.split('*').map((part, n) => (n % 2 ? make('i', {textContent: part}) : part));
  const bare = words => words.replace(/\*/g, '');

  /** One knob: a slider or a list of choices, with its name and its value in words. */
  class Knob {
    constructor(fixed, described, id, changed) {
      Object.assign(this, fixed, described);
      this.output = make('output', {}, {for: id});
      const name = make('label', {htmlFor: id}, {}, with_symbols(this.label));
      if (this.choices) {
        this.input = make('select', {id, onchange: () => changed(Number(this.input.value))}, {},
          this.choices.map((text, n) => make('option', {textContent: bare(text), value: n})));
        this.element = make('div', {className: 'live-knob'}, {}, [name, this.input]);
      } else {
        this.input = make('input', {id, type: 'range', min: 0, max: steps, step: 1,
          oninput: () => changed(this.#value_of(Number(this.input.value) / steps))});
        // A finger that comes by while it scrolls the page has changed nothing.
        let before;
        this.input.addEventListener('pointerdown', () => { before = this.input.value; });
        this.input.addEventListener('pointercancel', () => {
          this.input.value = before;
          this.input.dispatchEvent(new Event('input'));
        });
        this.element = make('div', {className: 'live-knob'}, {}, [name, this.output, this.input]);
      }
    }

    /** Whole numbers stay whole; others have no more digits than the slider's steps tell apart. */
    #value_of(part) {
      const {least, most} = this;
      const value = this.log ? least * (most / least) ** part : least + part * (most - least);
      const decimals = Math.max(0, Math.ceil(-Math.log10((most - least) / steps)));
      const rounded = this.whole ? Math.round(value) : Number(this.log ? value.toPrecision(3) : value.toFixed(decimals));
      const near_start = Math.abs(part - this.#part_of(this.start)) < 0.5 / steps;
      return this.clamped(near_start ? this.start : rounded);
    }

    #part_of(value) {
      const {least, most} = this;
      return this.log ? Math.log(value / least) / Math.log(most / least) : (value - least) / (most - least);
    }

    clamped(value) {
      if (!Number.isFinite(value)) return this.start;
      const inside = Math.max(this.least, Math.min(this.most, value));
      return this.choices || this.whole ? Math.round(inside) : inside;
    }

    show(value) {
      if (this.choices) {
        this.input.value = String(value);
        return;
      }
      this.input.value = String(Math.round(this.#part_of(value) * steps));
      this.output.textContent = this.words ? this.words(value) : live.with_unit(value, this.unit, 4);
      this.input.setAttribute('aria-valuetext', this.output.textContent);
    }
  }

  /** One picture of a figure. What turns is turned by dragging and by the arrows. */
  class Panel {
    constructor({draw, view, ...described}, figure) {
      Object.assign(this, described, {draw_with: draw});
      this.first_view = {...view};
      this.view = {...this.first_view};
      this.canvas = make('canvas', {}, {role: 'img', 'aria-label': this.label});
      this.canvas.style.setProperty('--aspect', String(this.aspect ?? 1));
      this.painter = new player.CanvasPainter(this.canvas);
      if (this.turns || this.drag || this.press) this.#listen(figure);
    }

    get size() {
      return {width: this.canvas.clientWidth, height: this.canvas.clientHeight};
    }

    draw(state, palette) {
      const {size, painter, view} = this;
      if (!size.width || !size.height) return;
      painter.begin(size, palette.paper);
      this.picture = {painter, palette, size, view};
      this.draw_with(this.picture, state);
    }

    turn(azimuth, elevation) {
      this.view.azimuth += azimuth;
      this.view.elevation = Math.max(-1.5, Math.min(1.5, this.view.elevation + elevation));
    }

    #listen(figure) {
      const {canvas} = this;
      canvas.tabIndex = 0;
      canvas.setAttribute('role', 'application');
      canvas.classList.add(this.turns ? 'turns' : this.press ? 'presses' : 'draws');
      const place_of = event => {
        const box = canvas.getBoundingClientRect();
        return [event.clientX - box.left, event.clientY - box.top];
      };
      let last;
      const act = (event, begins) => {
        const now = place_of(event);
        if (this.drag) figure.set(this.drag(this.picture.plot, now, figure.state, begins) ?? {});
        else if (!begins) {
          this.turn(-0.009 * (now[0] - last[0]), 0.009 * (now[1] - last[1]));
          figure.draw();
        }
        last = now;
      };
      if (this.press) canvas.addEventListener('click', event => figure.set(this.press(this.picture, place_of(event), figure.state) ?? {}));
      else {
        // A finger that sets out upwards or downwards scrolls the page, and takes hold of nothing.
        let held; // where a finger has come down that has not set out yet
        const sets_out_upright = event => Math.abs(event.clientY - held.clientY) >= Math.abs(event.clientX - held.clientX);
        canvas.addEventListener('pointerdown', event => {
          canvas.setPointerCapture(event.pointerId);
          if (event.pointerType === 'touch') held = event;
          else act(event, true);
        });
        const take_hold = () => {
          if (held) act(held, true);
          held = undefined;
        };
        canvas.addEventListener('pointermove', event => {
          if (!canvas.hasPointerCapture(event.pointerId) || (held && sets_out_upright(event))) return;
          take_hold();
          act(event, false);
        });
        canvas.addEventListener('pointerup', take_hold);
        canvas.addEventListener('pointercancel', () => { held = undefined; });
      }
      canvas.addEventListener('keydown', event => {
        const way = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
        if (!way || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        if (this.turns) {
          this.turn(0.1 * way[0], 0.1 * way[1]);
          figure.draw();
        } else figure.set(this.key?.(way, figure.state) ?? {});
      });
    }
  }

  class Figure {
    time = 0;
    drawn = [];
    texts = {}; // those that differ from their start
    #in_sight = false;

    constructor(element, name, module, run, own_texts) {
      Object.assign(this, {element, name, module, described: live.figures[name], run, own_texts});
      this.#make_panels();
      this.#make_controls();
      this.values = Object.fromEntries(this.knobs.map(({name: knob, start}) => [knob, start]));
      this.described.attach?.(this);
      element.classList.add('ready');
      this.#watch_the_page();
      this.#take(run);
      this.is_playing = Boolean(this.duration) && !this.calm.matches;
      this.#show_playing();
    }

    get columns() { return this.run.columns; }
    get state() {
      return live.state_of(this.described, this.run, this.time, this.knobs.map(({name}) => this.values[name]));
    }
    get duration() { return this.described.duration?.(this.run) ?? 0; }

    /** A text as it stands, and as it was at the start. */
    text(name) { return this.texts[name] ?? this.start_of(name); }
    start_of(name) { return this.own_texts[name] ?? this.run.texts[name]; }

    #make_panels() {
      this.panels = this.described.panels.map(panel => new Panel(panel, this));
      this.stage = make('div', {className: 'live-panels'}, {}, this.panels.map(({canvas}) => canvas));
      this.element.querySelector('.live-picture').after(this.stage);
    }

    #make_controls() {
      const id = `knob_${this.name}`;
      this.knobs = this.run.knobs.map(fixed => {
        const {name} = fixed;
        return new Knob(fixed, this.described.knobs[name], `${id}_${name.replace(/\W/g, '_')}`, value => this.set({...this.described.knobs[name].also, [name]: value}));
      });
      const shown = this.knobs.map(({element}) => element);
      this.reset_button = button('Reset', () => this.reset());
      this.copy_button = button('Copy link', () => this.#copy());
      this.said = make('span', {className: 'live-said'}, {role: 'status'});
      const buttons = make('div', {className: 'live-buttons'}, {}, [this.reset_button, this.copy_button, this.said]);
      if (this.duration) {
        this.play_button = button('Play', () => this.#set_playing(!this.is_playing));
        this.clock = make('input', {type: 'range', min: 0, max: 1000, step: 1, value: 0, oninput: () => {
          this.#set_playing(false);
          this.seek((Number(this.clock.value) / 1000) * this.duration);
        }}, {'aria-label': 'Time'});
        this.clock_words = make('span', {className: 'live-clock'}, {'aria-hidden': 'true'});
        buttons.prepend(this.play_button, this.clock, this.clock_words);
      }
      this.finding = make('p', {className: 'live-finding'}, {'aria-live': 'polite'});
      const hint = this.described.hint ? [make('p', {className: 'live-hint'}, {}, with_symbols(this.described.hint))] : [];
      this.stage.after(make('div', {className: 'live-knobs'}, {role: 'group', 'aria-label': 'Knobs'}, shown), buttons, this.finding, ...hint);
    }

    /** Sets knobs, and `drawn` where that is among them. Several calls before the next run count as one. */
    set(changes) {
      for (const knob of this.knobs)
        if (knob.name in changes) this.values[knob.name] = knob.clamped(Number(changes[knob.name]));
      if (changes.drawn) this.drawn = [...changes.drawn];
      const written = this.described.changed?.(this, changes) ?? changes;
      for (const name of Object.keys(this.run.texts)) if (name in written) this.texts[name] = written[name];
      return this.#rerun();
    }

    reset() {
      this.drawn = [];
      this.texts = {};
      this.described.reset?.(this);
      for (const panel of this.panels) Object.assign(panel.view, panel.first_view);
      this.time = 0;
      return this.set(Object.fromEntries(this.knobs.map(({name, start}) => [name, start])));
    }

    async #rerun() {
      this.is_stale = true;
      this.running ??= (async () => {
        while (this.is_stale) {
          this.is_stale = false;
          const has_time = frame_by_frame();
          const goes_on = async said => {
            this.described.progress?.(this, said);
            return (await has_time()) && !this.is_stale;
          };
          const run = await this.module.run(this.knobs.map(({name}) => this.values[name]), this.drawn, goes_on,
            {...this.own_texts, ...this.texts});
          if (!run) continue; // a knob was turned meanwhile
          this.refusal = run.refusal;
          if (run.refusal) this.#refuse();
          else this.#take(run);
        }
        this.running = undefined;
      })();
      return this.running;
    }

    #refuse() {
      clearTimeout(this.telling);
      this.finding.textContent = this.refusal;
      this.described.refused?.(this);
      this.element.dispatchEvent(new Event('told'));
    }

    #take(run) {
      if (run !== this.run) this.last_run = this.run;
      this.run = run;
      for (const knob of this.knobs) knob.show(this.values[knob.name]);
      this.time = Math.min(this.time, this.duration);
      this.draw();
      this.described.took?.(this);
      this.#tell();
    }

    #tell() {
      const text = this.described.finding(this.state, this.last_run);
      clearTimeout(this.telling);
      // Who drags a knob is told where it stops.
      this.telling = setTimeout(() => {
        if (this.finding.textContent !== bare(text)) this.finding.replaceChildren(...with_symbols(text));
        this.element.dispatchEvent(new Event('told'));
      }, 150);
    }

    draw() {
      this.palette ??= player.palette_of(this.element);
      const {state} = this;
      for (const panel of this.panels) panel.draw(state, this.palette);
      if (!this.clock) return;
      const shown = this.described.clock?.(state) ?? `${this.time.toFixed(this.duration < 10 ? 2 : 1)} s`;
      this.clock.value = String(Math.round((1000 * this.time) / this.duration));
      this.clock.setAttribute('aria-valuetext', shown);
      this.clock_words.textContent = shown;
    }

    seek(seconds) {
      this.time = Math.max(0, Math.min(this.duration, seconds));
      this.draw();
    }

    pause() { this.#set_playing(false); }

    #set_playing(is_playing) {
      this.is_playing = is_playing;
      this.#show_playing();
    }

    #show_playing() {
      if (!this.play_button) return;
      this.play_button.textContent = this.is_playing ? 'Pause' : 'Play';
      this.last_tick = undefined;
      this.#request();
    }

    /** The next picture, unless nobody would see it. */
    #request() {
      if (this.requested || !this.is_playing || !this.#in_sight) return;
      this.requested = requestAnimationFrame(now => {
        this.requested = undefined;
        const passed = Math.min(0.1, (now - (this.last_tick ?? now)) / 1000) * (this.described.speed?.(this.run) ?? 1);
        this.last_tick = now;
        this.time = this.time + passed > this.duration ? 0 : this.time + passed;
        this.draw();
        this.#request();
      });
    }

    /** This figure as it stands, as an address. */
    get link() {
      const given = new URLSearchParams();
      for (const {name, start} of this.knobs) if (this.values[name] !== start) given.set(name, String(this.values[name]));
      if (this.drawn.length) given.set('drawn', this.drawn.join(','));
      for (const name of Object.keys(this.texts)) if (this.text(name) !== this.start_of(name)) given.set(name, this.text(name));
      return `${location.href.split('#')[0]}#${this.element.id}?${given}`;
    }

    async #copy() {
      const {link} = this;
      history.replaceState(null, '', link);
      const copied = await navigator.clipboard?.writeText(link).then(() => true, () => false);
      this.said.textContent = copied ? 'Copied' : 'The link is in the address bar';
    }

    #watch_the_page() {
      const seen = new Set();
      const watch = new IntersectionObserver(entries => {
        for (const {isIntersecting, target} of entries) seen[isIntersecting ? 'add' : 'delete'](target);
        this.#in_sight = seen.size > 0;
        this.last_tick = undefined;
        this.#request();
      }, {threshold: 0.2});
      document.fonts?.load('italic 14px KaTeX_Math').then(() => this.draw());
      const resized = new ResizeObserver(() => this.draw());
      addEventListener('predicted', () => {
        this.draw();
        if (!this.refusal) this.#tell();
      });
      for (const {canvas} of this.panels) {
        resized.observe(canvas);
        watch.observe(canvas);
      }
      const recolour = () => {
        this.palette = undefined;
        this.draw();
      };
      new MutationObserver(recolour).observe(document.documentElement, {attributes: true, attributeFilter: ['class']});
      matchMedia('(prefers-color-scheme: dark)').addEventListener('change', recolour);
      this.calm = matchMedia('(prefers-reduced-motion: reduce)');
      this.calm.addEventListener('change', () => {
        if (this.calm.matches) this.pause();
      });
    }
  }

  const bytes_of = text => Uint8Array.from(atob(text), letter => letter.charCodeAt(0));

  /** Loads what the figure needs, once. */
  function wake(element) {
    element.waking ??= (async () => {
      const name = element.dataset.live;
      if (!live.modules[name])
        await new Promise((done, failed) => {
          document.head.append(make('script', {src: element.dataset.script, onload: done, onerror: () => failed(new Error('no script'))}));
        });
      const module = await live.Module.from(bytes_of(live.modules[name]));
      delete live.modules[name];
      // A page of its own brings the texts that its figure begins with.
      const own_texts = JSON.parse(element.querySelector('script.live-texts')?.textContent ?? '{}');
      const run = await module.run([], [], frame_by_frame(), own_texts);
      const sound = run.refusal ? await module.run([], [], frame_by_frame()) : run;
      const figure = new Figure(element, name, module, sound, own_texts);
      if (run.refusal) await figure.set({});
      element.live = figure;
      return figure;
    })();
    return element.waking;
  }

  const changes_of = text => {
    const changes = Object.fromEntries(new URLSearchParams(text));
    if (changes.drawn) changes.drawn = changes.drawn.split(',').map(Number);
    return changes;
  };

  /** "#live_NAME?knob=value": a figure in a state. */
  async function follow_address() {
    const [, id, query] = /^#(live_\w+)\?(.*)$/.exec(location.hash) ?? [];
    const element = id && document.getElementById(id);
    if (element?.dataset.script === undefined) return;
    element.scrollIntoView({block: 'start'});
    await (await wake(element)).set(changes_of(query));
  }

  function start() {
    const figures = document.querySelectorAll('figure.live[data-script]');
    if (typeof WebAssembly === 'undefined') {
      for (const element of figures) {
        element.classList.add('lifeless');
        element.append(make('p', {className: 'live-absent', textContent: 'This figure is computed by WebAssembly, which this browser lacks.'}));
      }
      return;
    }
    const near = new IntersectionObserver(entries => {
      for (const {isIntersecting, target} of entries)
        if (isIntersecting) {
          near.unobserve(target);
          wake(target).catch(error => {
            target.classList.add('lifeless');
            throw error;
          });
        }
    }, {rootMargin: '600px'});
    for (const element of figures) near.observe(element);
    document.addEventListener('click', async event => {
      const link = event.target.closest('a.live-set');
      const element = link && document.getElementById(link.hash.slice(1));
      if (element?.dataset.script === undefined) return;
      event.preventDefault();
      element.scrollIntoView({block: element.offsetHeight > innerHeight ? 'start' : 'nearest'});
      await (await wake(element)).set(changes_of(link.dataset.set));
    });
    addEventListener('hashchange', follow_address);
    follow_address();
  }

  document.addEventListener('DOMContentLoaded', start);
})();
