// On which page of a PDF that Chromium wrote each of its link targets lies. Chromium leaves all objects but the streams
// as plain text.

/** The numbers of the page objects in reading order. */
function page_objects(objects, number) {
  const object = objects.get(number);
  if (/\/Type \/Page\b/.test(object)) return [number];
  const kids = /\/Kids \[([^\]]*)\]/.exec(object)[1];
  return [...kids.matchAll(/(\d+) 0 R/g)].flatMap(([, kid]) => page_objects(objects, kid));
}

/** From a target's name to {page, height}: its page, counted from 1, and how high above the foot of the paper it lies, in points. */
export function places_of_destinations(pdf) {
  const text = pdf.toString('latin1');
  const objects = new Map(
    [...text.matchAll(/\n(\d+) 0 obj\n([\s\S]*?)\nendobj/g)].map(([, number, object]) => [number, object]),
  );
  const root = [...objects].find(([, object]) => /\/Type \/Pages\b/.test(object) && !object.includes('/Parent'))[0];
  const place = new Map(page_objects(objects, root).map((number, index) => [number, index + 1]));
  return new Map(
    [...text.matchAll(/\/([\w.-]+) \[(\d+) 0 R \/XYZ \S+ (\S+)/g)].map(([, name, page, height]) => [name, {page: place.get(page), height: Number(height)}]),
  );
}
