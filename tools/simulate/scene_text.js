// The text of a scene: how it is laid out, and what becomes of it when something is added, changed or switched off.
(() => {
  const live = (globalThis.tumble_live ??= {figures: {}, modules: {}});
  const width = 116;

  const entries_of = value => (Array.isArray(value) ? value.map(entry => ['', entry])
    : Object.entries(value).map(([key, entry]) => [`${JSON.stringify(key)}: `, entry]));

  const is_leaf = value => value === null || typeof value !== 'object';

  function in_one_line(value) {
    if (is_leaf(value)) return JSON.stringify(value);
    const inner = entries_of(value).map(([key, entry]) => key + in_one_line(entry)).join(', ');
    return Array.isArray(value) ? `[${inner}]` : inner ? `{ ${inner} }` : '{}';
  }

  /** JSON in which what is short enough keeps to one line, but for the scene and its lists, as in the scenes of the course. */
  function laid_out(value, indent = '', used = 0) {
    const line = in_one_line(value);
    if (is_leaf(value) || (indent !== '' && indent.length + used + line.length <= width)) return line;
    const [open, close] = Array.isArray(value) ? '[]' : '{}', deeper = `${indent}  `;
    const lines = entries_of(value).map(([key, entry]) => `${deeper}${key}${laid_out(entry, deeper, key.length)}`);
    return lines.length ? `${open}\n${lines.join(',\n')}\n${indent}${close}` : line;
  }

  const text_of = scene => `${laid_out(scene)}\n`;

  /** What an effect or a body is called on the page. */
  const name_of = part => part.name ?? part.kind.replaceAll('_', ' ');

  const movable = scene => scene.bodies.filter(body => !body.static);
  const last_solid = scene => (movable(scene).findLast(body => body.solid || body.inertia) ?? scene.bodies.at(-1)).name;

  /** What a new effect of each kind begins with; it acts on what the scene has. */
  const new_effects = {
    gravity: () => ({acceleration: [0, 0, -9.81]}),
    gravity_as_acceleration: () => ({acceleration: [0, 0, -9.81]}),
    point_gravity: () => ({strength: 10, centre: [0, 0, 0]}),
    linear_damping: () => ({rate: 0.2}),
    angular_damping: () => ({rate: 0.2}),
    quadratic_drag: () => ({coefficient: 0.05, wind: [0, 0, 0]}),
    magnus: () => ({strength: 0.1}),
    buoyancy: () => ({density: 1000, radius: 0.1, surface: 0}),
    spring: scene => ({bodies: [last_solid(scene)], stiffness: 50, damping: 1, anchor: [0, 0, 2]}),
    spring_between: scene => ({first: scene.bodies[0].name, second: last_solid(scene), stiffness: 50, rest_length: 1}),
    thruster: scene => ({bodies: [last_solid(scene)], force: [0, 0, 2], point: [0.1, 0.2, 0]}),
    reaction_wheel: scene => ({bodies: [last_solid(scene)], axis: [0, 0, 1], torque: 0.01}),
  };

  const new_bodies = {
    point: () => ({mass: 0.1}),
    ball: () => ({solid: {shape: 'sphere', radius: 0.1}, mass: 0.5}),
    box: () => ({solid: {shape: 'box', size: [0.2, 0.3, 0.5]}, mass: 1}),
    rod: () => ({solid: {shape: 'cylinder', radius: 0.02, height: 0.6}, mass: 0.3}),
    post: () => ({static: true, solid: {shape: 'box', size: [0.1, 0.1, 0.1]}}),
  };

  /** An effect of that kind, for this scene. */
  const new_effect = (scene, kind) => ({kind, ...new_effects[kind](scene)});

  /** A body of that kind with a name that no other has, above the others. */
  function new_body(scene, kind) {
    const taken = new Set(scene.bodies.map(({name}) => name));
    let name = kind;
    for (let n = 2; taken.has(name); ++n) name = `${kind} ${n}`;
    const height = Math.max(0, ...scene.bodies.map(({position}) => position?.[2] ?? 0));
    return {name, ...new_bodies[kind](), position: [0, 0, Number((height + 0.5).toFixed(2))]};
  }

  /** Sets what a path such as "solid.radius" leads to. */
  function set_at(part, path, value) {
    const keys = path.split('.');
    const holder = keys.slice(0, -1).reduce((inner, key) => (inner[key] ??= {}), part);
    holder[keys.at(-1)] = value;
  }

  const is_called = (part, word) => part.name === word || part.kind === word;

  /**
   * Changes a scene as words of an address ask: "thruster=on" and "gravity=off" by name or kind of an effect,
   * "box.angular_velocity=[0,5,0]" by the name of a body or an effect, "scene.step.per_second=7" for the scene itself. What is
   * switched off goes to the list `aside`, from which it is taken when it is switched on; otherwise a new one begins.
   */
  function change(scene, aside, changes) {
    scene.effects ??= [];
    for (const [word, value] of Object.entries(changes)) {
      const [, name, path] = /^([^.]*)\.?(.*)$/.exec(word);
      if (path) {
        const parts = name === 'scene' ? [scene] : [...scene.bodies, ...scene.effects, ...aside].filter(part => is_called(part, name));
        for (const part of parts) set_at(part, path, JSON.parse(value));
      } else if (value === 'off') {
        aside.push(...scene.effects.filter(effect => is_called(effect, name)));
        scene.effects = scene.effects.filter(effect => !is_called(effect, name));
      } else if (value === 'on' && !scene.effects.some(effect => is_called(effect, name))) {
        const kept = aside.findIndex(effect => is_called(effect, name));
        if (kept >= 0) scene.effects.push(...aside.splice(kept, 1));
        else if (new_effects[name]) scene.effects.push(new_effect(scene, name));
      }
    }
  }

  live.scene_text = {text_of, name_of, new_effect, new_body, change, set_at, kinds: Object.keys(new_effects), bodies: Object.keys(new_bodies)};
})();
