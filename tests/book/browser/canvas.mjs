// What the tests of the player share: a clock in their hands, and the pixels of a canvas.

/// Scripts of the page get pictures only when a test calls step(); so nothing depends on how fast the machine is.
export function stop_the_clock(page) {
  return page.addInitScript(() => {
    let waiting = [], now = 1000;
    window.requestAnimationFrame = action => waiting.push(action);
    window.next_picture = milliseconds => {
      now += milliseconds;
      const actions = waiting;
      waiting = [];
      for (const action of actions) action(now);
      return actions.length;
    };
  });
}

/// `count` pictures, each `milliseconds` after the one before; returns how many of them anybody wanted.
export function step(page, count, milliseconds) {
  return page.evaluate(([pictures, passed]) => {
    let wanted = 0;
    for (let n = 0; n < pictures; ++n) wanted += window.next_picture(passed) > 0 ? 1 : 0;
    return wanted;
  }, [count, milliseconds]);
}

/// Waits for what the browser does in its own time. It asks now and then, since the page's pictures stand still.
export const wait_until = (page, condition) => page.waitForFunction(condition, undefined, {polling: 20});

/// The first player of the page with `expression` of it, such as 'time'.
export const player_of = page => page.locator('figure.player').first();
export const ask = (page, action, argument) => player_of(page).evaluate((figure, [text, given]) =>
  new Function('player', 'given', `return ${text};`)(figure.player, given), [action, argument]);

/// Every view's picture, to be compared.
export const pictures = page => ask(page, 'player.views.map(view => view.canvas.toDataURL())');

/// [[red, green, blue], ...] at points in CSS pixels of a view's canvas.
export function pixels(page, view, points) {
  return ask(page, `given[1].map(([x, y]) => {
    const {canvas} = player.views[given[0]];
    const ratio = canvas.width / canvas.clientWidth;
    return [...canvas.getContext('2d').getImageData(Math.floor(x * ratio), Math.floor(y * ratio), 1, 1).data].slice(0, 3);
  })`, [view, points]);
}

/// A colour of the page's style sheet as [red, green, blue].
export async function named_colour(page, name) {
  const hex = await player_of(page).evaluate((figure, property) =>
    getComputedStyle(figure).getPropertyValue(property).trim(), name);
  return [1, 3, 5].map(start => parseInt(hex.slice(start, start + 2), 16));
}

/// How far apart two hues are, in degrees, or Infinity where a colour is nearly grey.
export function hue_distance(one, other) {
  const hue = ([red, green, blue]) => {
    const chroma = Math.max(red, green, blue) - Math.min(red, green, blue);
    if (chroma < 25) return NaN;
    return Math.atan2(Math.sqrt(3) * (green - blue), 2 * red - green - blue) * 180 / Math.PI;
  };
  const difference = Math.abs(hue(one) - hue(other)) % 360;
  return Number.isNaN(difference) ? Infinity : Math.min(difference, 360 - difference);
}
