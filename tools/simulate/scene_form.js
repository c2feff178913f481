// A scene as a form: a fold for each body and each effect, with an input for every number in it, named with its unit.
(() => {
  const live = globalThis.tumble_live;
  const {made} = live.scene_tables;
  const words = key => key.replaceAll('_', ' ');
  const is_vector = value => Array.isArray(value) && value.length === 3 && value.every(Number.isFinite);

  /** Keys that a body shows though its text leaves them out. */
  const always = body => [
    ...(body.many?.position_between ? [] : ['position']),
    ...(body.static || body.many?.velocity_between ? [] : ['velocity']),
    ...(body.static || !(body.solid || body.inertia) || body.many?.angular_velocity_between ? [] : ['angular_velocity']),
  ];

  /** [[path, value, unit]]: the numbers and vectors of a part of a scene. `units` by the kinds of objects. */
  function numbers_of(part, units, kind, shown = []) {
    const own = {...Object.fromEntries(shown.map(key => [key, [0, 0, 0]])), ...part};
    return Object.entries(own).flatMap(([key, value]) => {
      const unit = units[kind]?.[key] ?? '';
      if (Number.isFinite(value) || is_vector(value)) return [[key, value, unit]];
      if (value === null || typeof value !== 'object' || Array.isArray(value)) return [];
      const inner = {solid: value.shape, many: 'many', orientation: 'axis_angle', step: 'step'}[key];
      return inner ? numbers_of(value, units, inner).map(([path, number, its]) => [`${key}.${path}`, number, its]) : [];
    });
  }

  /** `changed(action)` is called where a reader changes the scene: action(scene, aside) carries it out. */
  class Form {
    #ids = 0;

    constructor(id, changed) {
      Object.assign(this, {id, changed});
      this.element = made('fieldset', {className: 'scene-form'}, {}, [made('legend', {textContent: 'The scene as a form'})]);
      this.body = made('div');
      this.element.append(this.body);
    }

    /** Shows the scene and the effects that are switched off. Folds that are open stay open. */
    show(scene, aside, said) {
      const open = new Set([...this.body.querySelectorAll('details[open]')].map(({dataset}) => dataset.name));
      const units = JSON.parse(said.units);
      this.#ids = 0;
      this.body.replaceChildren(...this.#scene(scene, units, said), ...this.#bodies(scene, units), ...this.#effects(scene, aside, units));
      for (const fold of this.body.querySelectorAll('details')) fold.open = open.has(fold.dataset.name);
    }

    #id() { return `${this.id}_${++this.#ids}`; }

    #fold(name, title, children) {
      const fold = made('details', {className: 'scene-fold'}, {}, [made('summary', {textContent: title}), ...children]);
      fold.dataset.name = name;
      return fold;
    }

    #input(value, label, set) {
      const id = this.#id();
      return made('input', {id, type: 'number', step: 'any', value: String(value), oninput: event => {
        if (Number.isFinite(event.target.valueAsNumber)) set(event.target.valueAsNumber);
      }}, {'aria-label': label});
    }

    /** One number, or the three of a vector; `find(scene, aside)` finds the part again that they belong to. */
    #numbers(owner, path, value, unit, find) {
      const name = words(path.replaceAll('.', ', '));
      const set = (number, axis) => this.changed((scene, aside) => {
        const part = find(scene, aside);
        if (axis === undefined) live.scene_text.set_at(part, path, number);
        else {
          const vector = path.split('.').reduce((inner, key) => inner?.[key], part) ?? [0, 0, 0];
          live.scene_text.set_at(part, path, vector.with(axis, number));
        }
      });
      const inputs = is_vector(value)
        ? value.map((number, axis) => this.#input(number, `${owner}: ${name} ${'xyz'[axis]}${unit && `, ${unit}`}`, changed => set(changed, axis)))
        : [this.#input(value, `${owner}: ${name}${unit && `, ${unit}`}`, changed => set(changed))];
      return made('div', {className: 'scene-numbers'}, {},
        [made('span', {textContent: unit ? `${name} (${unit.replace('^2', '²').replace('^3', '³')})` : name}, {'aria-hidden': 'true'}),
          made('div', {className: 'scene-inputs'}, {}, inputs)]);
    }

    #button(text, action) {
      return made('button', {type: 'button', textContent: text, onclick: () => this.changed(action, true)});
    }

    #adder(what, kinds, add) {
      const choice = made('select', {id: this.#id()}, {'aria-label': `Which ${what}`}, kinds.map(kind => made('option', {value: kind, textContent: words(kind)})));
      return made('div', {className: 'scene-adder'}, {}, [choice,
        this.#button(`Add ${/^[aeiou]/.test(what) ? 'an' : 'a'} ${what}`, scene => add(scene, choice.value))]);
    }

    #choice(scene, key, start, choices) {
      const id = this.#id();
      const select = made('select', {id, value: '', onchange: () => this.changed(now => {
        if (select.value === start) delete now[key];
        else now[key] = select.value;
      })}, {}, choices.map(word => made('option', {value: word, textContent: words(word)})));
      select.value = scene[key] ?? start;
      return made('div', {className: 'scene-numbers'}, {}, [made('label', {htmlFor: id, textContent: words(key)}), select]);
    }

    #scene(scene, units, said) {
      const rows = numbers_of(scene, units, 'scene').map(([path, value, unit]) => this.#numbers('the scene', path, value, unit, now => now));
      return [made('div', {className: 'scene-head', textContent: 'Steps'}), ...rows, this.#choice(scene, 'scheme', 'semi_implicit_euler', JSON.parse(said.schemes)),
        this.#choice(scene, 'turning_method', 'splitting', JSON.parse(said.methods))];
    }

    #bodies(scene, units) {
      const folds = scene.bodies.map((body, n) => this.#fold(`body ${body.name}`, body.name, [
        ...numbers_of(body, units, 'body', always(body)).map(([path, value, unit]) => this.#numbers(body.name, path, value, unit, now => now.bodies[n])),
        this.#button(`Remove ${body.name}`, now => { now.bodies.splice(n, 1); })]));
      return [made('div', {className: 'scene-head', textContent: 'Bodies'}), ...folds,
        this.#adder('body', live.scene_text.bodies, (now, kind) => { now.bodies.push(live.scene_text.new_body(now, kind)); })];
    }

    #effects(scene, aside, units) {
      const item = (effect, n, is_on) => {
        const name = live.scene_text.name_of(effect), id = this.#id();
        const bodies = effect.bodies ?? (effect.first ? [effect.first, effect.second] : undefined);
        const title = bodies ? `${name} (${bodies.join(', ')})` : name;
        const box = made('input', {id, type: 'checkbox', checked: is_on, onchange: () => this.changed((now, off) => {
          now.effects ??= [];
          const [from, to] = is_on ? [now.effects, off] : [off, now.effects];
          to.push(...from.splice(n, 1));
        }, true)});
        const label = made('label', {htmlFor: id}, {}, [box, ` ${title}`]);
        const find = (now, off) => (is_on ? now.effects : off)[n];
        const numbers = numbers_of(effect, units, effect.kind).map(([path, value, unit]) => this.#numbers(name, path, value, unit, find));
        return made('div', {className: 'scene-effect'}, {}, [label, this.#fold(`effect ${title}`, `Numbers of ${name}`, numbers)]);
      };
      return [made('div', {className: 'scene-head', textContent: 'Effects'}), ...(scene.effects ?? []).map((effect, n) => item(effect, n, true)),
        ...aside.map((effect, n) => item(effect, n, false)),
        this.#adder('effect', live.scene_text.kinds, (now, kind) => { (now.effects ??= []).push(live.scene_text.new_effect(now, kind)); })];
    }
  }

  live.SceneForm = Form;
})();
