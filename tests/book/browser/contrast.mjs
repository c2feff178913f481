// Runs inside the page: how well the parts of its drawings stand out from what lies behind them (WCAG 2, 1.4.3).

/// [{figure, part, colour, contrast}] for every text, axis and data line of the drawings on this page.
export function contrasts_in_figures() {
  const canvas = document.createElement('canvas').getContext('2d', {willReadFrequently: true});
  const components = colour => {
    canvas.clearRect(0, 0, 1, 1);
    canvas.fillStyle = colour;
    canvas.fillRect(0, 0, 1, 1);
    return [...canvas.getImageData(0, 0, 1, 1).data];
  };
  const luminance = colour => {
    const [red, green, blue] = components(colour).slice(0, 3).map(value => value / 255)
      .map(value => value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  };
  const background = element => {
    const {backgroundColor} = getComputedStyle(element);
    if (components(backgroundColor)[3] === 255) return backgroundColor;
    return element.parentElement ? background(element.parentElement) : 'white';
  };
  const contrast = (one, other) => {
    const [darker, lighter] = [luminance(one), luminance(other)].sort((a, b) => a - b);
    return (lighter + 0.05) / (darker + 0.05);
  };
  const stroke_of = line => line.closest('[stroke]')?.getAttribute('stroke') ?? '';
  return [...document.querySelectorAll('figure svg')].flatMap((figure, number) => {
    const behind = background(figure);
    const measured = (part, colour) =>
      ({figure: `drawing ${number + 1}`, part, colour, contrast: contrast(colour, behind)});
    const texts = [...figure.querySelectorAll('text')].filter(text => text.textContent.trim())
      .map(text => measured(`text "${text.textContent.trim()}"`, getComputedStyle(text).fill));
    const lines = [...figure.querySelectorAll('path, line, polyline')]
      // The grid is faint, and what has the paper's colour is the border of something else.
      .filter(line => getComputedStyle(line).stroke !== 'none' && !/--figure-(grid|paper)/.test(stroke_of(line)))
      .map(line => measured(stroke_of(line).includes('--figure-frame') ? 'axis' : 'line', getComputedStyle(line).stroke));
    return [...texts, ...lines];
  });
}
