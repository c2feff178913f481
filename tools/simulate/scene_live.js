// A scene to edit: its bodies in motion, its energies, a form and its text side by side, its plan and its books.
(() => {
  const live = globalThis.tumble_live;
  const {finding_of, plan_table, books_table, lines_of, made} = live.scene_tables;

  /** The player's scene of a run, made once. */
  const scene_of = ({columns, said}) => live.once(columns, 'scene', () => {
    const recording = JSON.parse(said.recording), {poses, time} = columns;
    const numbers = 7 * recording.bodies.length;
    recording.frames = Array.from(time, (_, n) => Array.from(poses.subarray(n * numbers, (n + 1) * numbers)));
    return new globalThis.tumble_player.Scene(recording, 24);
  });

  const world = {
    label: 'The bodies of the scene in 3D. Arrow keys and dragging turn the view.',
    aspect: 1.15,
    turns: true,
    view: {azimuth: 0, elevation: 0},
    draw({painter, palette, size, view}, state) {
      const scene = scene_of(state);
      const first = live.once(state.columns, `camera ${size.width} ${size.height}`,
        () => globalThis.tumble_player.first_cameras([scene], size)[0]);
      scene.draw(painter, size, {...first, azimuth: first.azimuth + view.azimuth, elevation: first.elevation + view.elevation},
        state.time, palette);
    },
  };

  const energies = {
    label: 'The kinetic energy of all bodies, the energy stored in gravity and springs, and their sum, against time.',
    aspect: 1.15,
    draw({painter, palette, size}, {columns, time}) {
      const {time: times, kinetic, stored} = columns;
      const sum = live.once(columns, 'sum', () => kinetic.map((value, n) => value + stored[n]));
      const range = live.once(columns, 'range', () => live.range_of([kinetic, stored, sum], {smallest: 1e-12}));
      const plot = new live.Plot(painter, palette, size, {label: '*t*', unit: 's', least: 0, most: times.at(-1)}, {label: '*E*', unit: 'J', ...range});
      plot.line([time, time], [range.least, range.most], palette.grid, {width: 2});
      [[kinetic, 0, []], [stored, 1, [6, 3]], [sum, 2, [2, 2]]].forEach(([values, n, dash]) =>
        plot.line(times, values, palette.bodies[n], {width: 1.8, dash}));
      plot.legend([['kinetic', palette.bodies[0]], ['stored', palette.bodies[1], [6, 3]], ['sum', palette.bodies[2], [2, 2]]]);
    },
  };

  const pause = () => new Promise(done => { setTimeout(done); });

  /**
   * What each line of the plan costs in a step, ns, and the `whole` step. The module repeats a part, on copies of the bodies, for
   * three milliseconds at a time; the time that the copies alone take is taken off, and the middle one of five such times stands.
   * Nothing, where the scene is changed meanwhile.
   */
  async function costs_of(figure) {
    const {module, run} = figure;
    const steps = Math.min(200, JSON.parse(run.said.books).steps);
    const time_of = (part, rounds, count) => {
      const start = performance.now();
      module.call('scene_run_part', part, rounds, count);
      return performance.now() - start;
    };
    const cost = async part => {
      let rounds = 1;
      while (time_of(part, rounds, steps) < 3 && rounds < 1 << 16) rounds *= 2;
      const times = [];
      for (let n = 0; n < 5; ++n) {
        await pause();
        if (figure.running || figure.run !== run) return undefined;
        times.push(time_of(part, rounds, steps) - time_of(part, rounds, 0));
      }
      return Math.max(0, times.sort((a, b) => a - b)[2]) * 1e6 / (rounds * steps);
    };
    const costs = new Map();
    const visited = lines_of(run.said).filter(line => line.visited > 0);
    for (const [part, key] of [...visited.map(line => line.key).entries(), [-1, 'whole']]) {
      const ns = await cost(part);
      if (ns === undefined) return undefined;
      costs.set(key, ns);
    }
    return costs;
  }

  /** What stands below the pictures. */
  class Editor {
    aside = []; // effects that are switched off

    constructor(figure) {
      this.figure = figure;
      const id = `scene_${figure.name}`;
      this.form = new live.SceneForm(id, (action, is_new_form) => this.#change(action, is_new_form));
      this.area = made('textarea', {id: `${id}_text`, spellcheck: false, rows: 24, oninput: () => figure.set({scene: this.area.value})},
        {autocapitalize: 'off', 'aria-describedby': `${id}_note`});
      this.note = made('p', {id: `${id}_note`, className: 'live-hint'});
      const text = made('div', {className: 'scene-text'}, {}, [made('label', {htmlFor: this.area.id, textContent: 'The scene as a file'}), this.area, this.note]);
      this.plan = made('div');
      this.books = made('div');
      this.measure = made('button', {type: 'button', textContent: 'Measure what each line costs', onclick: () => this.#measure()});
      // A chapter shows the scene and its plan; a page of its own is there to change it.
      const part = (title, element) => (figure.element.closest('.contents')
        ? made('details', {className: 'fold scene-part'}, {}, [made('summary', {textContent: title}), element]) : element);
      figure.finding.after(this.plan, made('div', {className: 'live-buttons'}, {}, [this.measure]),
        part('Change the scene', made('div', {className: 'scene-editor'}, {}, [this.form.element, text])), part('Its books', this.books));
    }

    get scene() {
      return JSON.parse(this.figure.text('scene'));
    }

    #change(action, is_new_form) {
      const {scene} = this;
      action(scene, this.aside);
      this.needs_form = is_new_form;
      this.figure.set({scene: live.scene_text.text_of(scene)});
    }

    /** The page's own scene with the changes that a link asks for. */
    changed(changes) {
      const scene = JSON.parse(this.figure.start_of('scene'));
      this.aside = [];
      live.scene_text.change(scene, this.aside, changes);
      return live.scene_text.text_of(scene);
    }

    #show_text() {
      const text = this.figure.text('scene');
      if (this.area.value !== text) this.area.value = text;
      this.area.removeAttribute('aria-invalid');
    }

    took() {
      const {figure} = this;
      this.#show_text();
      figure.said.textContent = '';
      this.form.element.disabled = false;
      this.note.textContent = `Save it under a name such as my_scene.json, and ./course simulate my_scene.json runs it too. It was ` +
        `computed in ${JSON.parse(figure.run.said.books).steps} steps.`;
      // Whoever types in the form keeps the input that they type in.
      const types_here = this.form.element.contains(document.activeElement) && document.activeElement.type === 'number';
      if (this.needs_form || !types_here) this.#show_form();
      this.needs_form = false;
      this.costs = undefined;
      this.measure.disabled = false;
      this.#show_plan();
      this.books.replaceChildren(books_table(figure.run.said));
    }

    /** A new form takes the place of the old one; the focus stays where it was. */
    #show_form() {
      const focused = this.form.element.contains(document.activeElement) ? document.activeElement.id : '';
      this.form.show(this.scene, this.aside, this.figure.run.said);
      if (focused) document.getElementById(focused)?.focus();
    }

    #show_plan() {
      const {run, last_run} = this.figure;
      this.plan.replaceChildren(plan_table(run.said, last_run?.said, this.costs));
    }

    refused() {
      this.#show_text();
      this.measure.disabled = true; // the module has dropped what it had run
      this.figure.said.textContent = '';
      this.area.setAttribute('aria-invalid', 'true');
      this.note.textContent = this.figure.refusal;
      let is_json = true;
      try { this.form.show(this.scene, this.aside, this.figure.run.said); } catch { is_json = false; }
      this.form.element.disabled = !is_json;
    }

    async #measure() {
      this.measure.disabled = true;
      this.costs = await costs_of(this.figure);
      if (!this.costs) return; // what comes of the change shows the button anew
      this.measure.disabled = false;
      this.#show_plan();
      this.figure.said.textContent = 'The plan now has a column with the costs';
    }
  }

  live.figures.scene = {
    title: 'A scene to edit: what does each of its steps consist of?',
    knobs: {},
    duration: ({columns}) => columns.time.at(-1),
    still_time: 0.6,
    panels: [world, energies],
    attach(figure) { figure.editor = new Editor(figure); },
    took(figure) { figure.editor.took(); },
    refused(figure) { figure.editor.refused(); },
    reset(figure) { figure.editor.aside = []; },
    progress(figure, {progress}) { if (progress) figure.said.textContent = `Computed: ${progress} %`; },
    changed(figure, changes) {
      if ('scene' in changes || !Object.keys(changes).length) return changes;
      return {scene: figure.editor.changed(changes)};
    },
    finding: ({said}, last_run) => finding_of(said, last_run?.said),
  };
})();
