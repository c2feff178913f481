// Every <figure class="player"> of a page comes to life: one set of controls, and a view for each of its recordings.
// The figure gets a property `player` with what a script may want: play(), pause(), seek(seconds), time, follow(number of a
// body, or nothing), followed, and views, each with its recording, its canvas, and project(point of the world) -> [x, y,
// distance] in CSS pixels of the canvas.
(() => {
  const player = (globalThis.tumble_player ??= {});
  const most_elevation = 1.5;
  const most_listed = 200; // bodies to choose from; of more, one is pressed in the picture

  function make(tag, properties = {}, attributes = {}) {
    const element = Object.assign(document.createElement(tag), properties);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    return element;
  }

  class View {
    constructor(holder, scene, description) {
      this.scene = scene;
      this.recording = scene.recording;
      this.canvas = make('canvas', {tabIndex: 0},
        {role: 'application', 'aria-label': `${this.recording.title}. ${description || this.#bodies()}`});
      this.painter = new player.CanvasPainter(this.canvas);
      holder.append(this.canvas);
    }

    #bodies() {
      const names = this.recording.bodies.map(({name}) => name);
      const more = names.length > 4 ? ` and ${names.length - 3} more` : '';
      return `A replay in 3D of ${(more ? names.slice(0, 3) : names).join(', ')}${more}.`;
    }

    get size() {
      return {width: this.canvas.clientWidth, height: this.canvas.clientHeight};
    }

    project(point) {
      return player.projection(this.camera, this.size)(point);
    }

    /** Which body there is at [x, y] in the picture, px. */
    body_at(point, time) {
      return this.scene.body_at(point, this.size, this.camera, time);
    }

    /** A view with fewer bodies than another beside it stays as it is when that one follows. */
    #aim(followed, time) {
      if (followed === undefined || followed >= this.recording.bodies.length) return undefined;
      this.camera.target = player.poses_at(this.recording, time)[followed].position;
      return followed;
    }

    draw(time, palette, body) {
      const {size} = this;
      if (!size.width || !size.height) return;
      const followed = this.#aim(body, time);
      this.painter.begin(size, palette.paper);
      this.scene.draw(this.painter, size, this.camera, time, palette, {followed});
    }
  }

  /** A function from a share of the duration, which draws a line there: in the drawing with the recording's name, if the page has one. Its first curve lasts as long. */
  function cursor_of(name) {
    const curve = document.querySelector(`.drawing [id$="_${name}_plot_1"]`);
    if (!curve) return () => {};
    const line = document.createElementNS('http://www.w3.org/2000/svg', 'line');
    line.classList.add('player-cursor');
    curve.ownerSVGElement.prepend(line); // below all names
    return share => {
      const {x, y, width, height} = curve.getBBox();
      const ends = {x1: x + share * width, x2: x + share * width, y1: y, y2: y + height};
      for (const [end, place] of Object.entries(ends)) line.setAttribute(end, place);
    };
  }

  class Player {
    time = 0;
    speed = 1;
    #last_tick = undefined;
    #is_in_sight = false;

    constructor(figure) {
      this.figure = figure;
      const views = figure.querySelector('.player-views');
      const description = views.getAttribute('aria-label') ?? '';
      const holders = [...views.querySelectorAll('.player-view')];
      const recordings = holders.map(holder => JSON.parse(holder.querySelector('script.player-recording').textContent));
      const scenes = player.scenes_of(recordings, 40);
      this.views = holders.map((holder, n) => new View(holder, scenes[n], description));
      // The still pictures made one image of the whole; now each canvas speaks for itself.
      views.removeAttribute('role');
      views.removeAttribute('aria-label');
      this.duration = Math.max(...this.views.map(({recording}) => player.duration_of(recording)));
      this.frame_time = this.views[0].recording.seconds_between_frames;
      this.move_cursor = cursor_of(figure.dataset.recording);
      this.can_follow = this.views.some(({scene}) => scene.can_follow);
      this.#make_controls();
      for (const view of this.views) this.#listen_to(view.canvas);
      figure.classList.add('live');
      this.#reset_view();
      this.#watch_the_page();
      this.is_playing = !this.calm.matches;
      this.#show_state();
    }

    play() { this.#set_playing(true); }
    pause() { this.#set_playing(false); }

    seek(seconds) {
      this.time = Math.max(0, Math.min(this.duration, seconds));
      this.draw();
    }

    draw() {
      this.palette ??= player.palette_of(this.figure);
      for (const view of this.views) view.draw(this.time, this.palette, this.followed);
      const shown = `${this.time.toFixed(this.duration < 10 ? 2 : 1)} s`;
      this.slider.value = String(Math.round(this.time / this.frame_time));
      this.slider.setAttribute('aria-valuetext', shown);
      this.clock.textContent = shown;
      this.move_cursor(this.time / this.duration);
    }

    #set_playing(is_playing) {
      this.is_playing = is_playing;
      this.#show_state();
    }

    #show_state() {
      this.button.classList.toggle('playing', this.is_playing);
      this.button.lastChild.textContent = this.is_playing ? 'Pause' : 'Play';
      this.#last_tick = undefined;
      if (this.is_playing) this.#request();
    }

    /** The next picture, unless nobody would see it. */
    #request() {
      if (this.requested || !this.is_playing || !this.#is_in_sight) return;
      this.requested = requestAnimationFrame(now => {
        this.requested = undefined;
        // A page that was asleep does not jump.
        const passed = Math.min(0.1, (now - (this.#last_tick ?? now)) / 1000);
        this.#last_tick = now;
        this.time += passed * this.speed;
        if (this.time > this.duration) this.time = 0;
        this.draw();
        this.#request();
      });
    }

    #reset_view() {
      this.has_first_view = true;
      const cameras = player.first_cameras(this.views.map(({scene}) => scene), this.views[0].size);
      this.views.forEach((view, n) => { view.camera = cameras[n]; });
      this.#aim_at(this.views[0].recording.follow);
    }

    /** From now on the camera goes with a body, or with none. */
    follow(body) {
      const turned = this.views.map(({camera: {azimuth, elevation}}) => ({azimuth, elevation}));
      if (body === undefined) {
        const cameras = player.first_cameras(this.views.map(({scene}) => scene), this.views[0].size);
        this.views.forEach((view, n) => { view.camera = {...cameras[n], ...turned[n]}; });
      }
      this.has_first_view = false;
      this.#aim_at(body);
      this.draw();
    }

    #aim_at(body) {
      this.followed = body;
      for (const view of this.views)
        if (body < view.recording.bodies.length)
          view.camera = player.following(view.camera, view.scene, body, player.poses_at(view.recording, this.time)[body].position);
      this.#show_followed();
    }

    #show_followed() {
      if (!this.bodies) return;
      const {bodies} = this.views[0].recording;
      const listed = bodies.length <= most_listed ? [...bodies.keys()] : this.followed === undefined ? [] : [this.followed];
      if (this.bodies.length !== listed.length + 1 || listed.length === 1)
        this.bodies.replaceChildren(make('option', {value: '', textContent: 'no body'}),
          ...listed.map(body => make('option', {value: String(body), textContent: bodies[body].name || `body ${body + 1}`})));
      this.bodies.value = this.followed ?? '';
    }

    /** Follows the next body, or the one before; after the last one none. */
    #follow_next(by) {
      const count = this.views[0].recording.bodies.length + 1; // with none
      const place = ((this.followed ?? -1) + 1 + by + count) % count;
      this.follow(place === 0 ? undefined : place - 1);
    }

    /** Turns or zooms all views alike, so that they can be compared. */
    #move_cameras({azimuth = 0, elevation = 0, zoom = 1}) {
      this.has_first_view = false;
      for (const {camera, scene} of this.views) {
        camera.azimuth += azimuth;
        camera.elevation = Math.max(-most_elevation, Math.min(most_elevation, camera.elevation + elevation));
        const {radius} = scene.bounds, body = scene.models[this.followed];
        camera.distance = Math.max(body ? Math.max(3 * body.radius, 1e-3 * radius) : 0.3 * radius, Math.min(60 * radius, camera.distance * zoom));
      }
      this.draw();
    }

    /** What the view's buttons and keys do. */
    actions = {
      '+': () => this.#move_cameras({zoom: 1 / 1.2}),
      '-': () => this.#move_cameras({zoom: 1.2}),
      Home: () => {
        this.#reset_view();
        this.draw();
      },
      ' ': () => this.#set_playing(!this.is_playing),
      ArrowLeft: () => this.#move_cameras({azimuth: -0.1}),
      ArrowRight: () => this.#move_cameras({azimuth: 0.1}),
      ArrowUp: () => this.#move_cameras({elevation: 0.1}),
      ArrowDown: () => this.#move_cameras({elevation: -0.1}),
    };
    following_actions = {
      f: () => this.#follow_next(1),
      F: () => this.#follow_next(-1),
      Escape: () => this.follow(undefined),
    };

    #make_controls() {
      const controls = make('div', {className: 'player-controls'}, {role: 'group', 'aria-label': 'Replay'});
      this.button = make('button', {type: 'button', className: 'player-play', onclick: this.actions[' ']});
      this.button.append(make('span', {className: 'player-icon'}, {'aria-hidden': 'true'}), 'Play');
      this.slider = make('input', {type: 'range', min: 0, max: Math.round(this.duration / this.frame_time), step: 1, value: 0,
        oninput: () => {
          this.pause();
          this.seek(Number(this.slider.value) * this.frame_time);
        }}, {'aria-label': 'Time'});
      this.clock = make('span', {className: 'player-clock'}, {'aria-hidden': 'true'});
      const speed = make('button', {type: 'button', textContent: '¼ speed', onclick: () => {
        this.speed = this.speed === 1 ? 0.25 : 1;
        speed.setAttribute('aria-pressed', String(this.speed !== 1));
      }}, {'aria-pressed': 'false'});
      const view_button = (text, label, key) =>
        make('button', {type: 'button', textContent: text, onclick: this.actions[key]}, {'aria-label': label, title: label});
      const view_buttons = make('div', {className: 'player-zoom'}, {role: 'group', 'aria-label': 'View'});
      view_buttons.append(view_button('−', 'Zoom out', '-'), view_button('+', 'Zoom in', '+'),
        view_button('↺', 'First view', 'Home'));
      controls.append(this.button, this.slider, this.clock, speed, view_buttons);
      if (this.can_follow) {
        this.bodies = make('select', {onchange: () => this.follow(this.bodies.value === '' ? undefined : Number(this.bodies.value))});
        const label = make('label', {className: 'player-follow', textContent: 'Follow '});
        label.append(this.bodies);
        controls.append(label);
        Object.assign(this.actions, this.following_actions);
      }
      const hint = make('p', {className: 'player-hint', id: `player-hint-${++hints}`,
        textContent: `Drag to turn the view. ${this.can_follow ? 'Press a body to follow it. ' : ''}`});
      hint.append(make('span', {className: 'by-keys', // see contents.css: a finger has none
        textContent: `Keys in the picture: arrows, +, −, Home, and space to play${this.can_follow ? '; F follows the next body, Escape none' : ''}.`}));
      for (const {canvas} of this.views) canvas.setAttribute('aria-describedby', hint.id);
      this.figure.append(controls, hint);
    }

    #listen_to(canvas) {
      canvas.addEventListener('keydown', event => {
        const action = this.actions[{'=': '+', '−': '-'}[event.key] ?? event.key];
        if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
        if (event.key === 'Escape' && this.followed === undefined) return; // whoever else waits for it
        event.preventDefault();
        action();
      });
      let x, y, way; // the longer the way of a pointer, the less it is a press
      canvas.addEventListener('pointerdown', event => {
        canvas.setPointerCapture(event.pointerId);
        [x, y, way] = [event.clientX, event.clientY, 0];
      });
      canvas.addEventListener('pointerup', event => {
        if (!this.can_follow || event.button !== 0 || !(way < 5)) return;
        const view = this.views.find(one => one.canvas === canvas);
        const body = view.body_at([event.offsetX, event.offsetY], this.time);
        if (body !== this.followed) this.follow(body);
      });
      canvas.addEventListener('pointermove', event => {
        if (!canvas.hasPointerCapture(event.pointerId)) return;
        way += Math.hypot(event.clientX - x, event.clientY - y);
        this.#move_cameras({azimuth: -0.009 * (event.clientX - x), elevation: 0.009 * (event.clientY - y)});
        [x, y] = [event.clientX, event.clientY];
      });
    }

    #watch_the_page() {
      new IntersectionObserver(([{isIntersecting}]) => {
        this.#is_in_sight = isIntersecting;
        this.#last_tick = undefined;
        this.#request();
      }, {threshold: 0.35}).observe(this.figure);
      const resized = new ResizeObserver(() => {
        if (this.has_first_view) this.#reset_view();
        this.draw();
      });
      for (const {canvas} of this.views) resized.observe(canvas);
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
  let hints = 0;

  function start() {
    for (const figure of document.querySelectorAll('figure.player')) figure.player = new Player(figure);
    // A page that is nothing but a player takes the recording's title.
    const heading = document.querySelector('.player-page h1'), only = document.querySelector('.player-page figure.player');
    if (!only) return;
    const {title} = only.player.views[0].recording;
    heading.textContent = document.title = title;
  }

  document.addEventListener('DOMContentLoaded', start);
})();
