// The shapes that the object is taken for: drawn on it, and with their sizes and how far the
// surface is from them as a list.

// A curve's length from point to point.
function lengthOf({points, closed}) {
  const ends = closed ? [...points, points[0]] : points;
  return ends.slice(1).reduce((sum, p, i) => sum + vectorOf(p).distanceTo(vectorOf(ends[i])), 0);
}

// In mm.
function sizeWords(primitive) {
  const mm = (length) => numberText(1000 * length);
  const {shape, radius: round, radius_low: low, radius_high: high, height} = primitive;
  const words = {
    box: () => primitive.size.map(mm).join(' × '),
    sphere: () => `⌀ ${mm(2 * round)}`,
    cylinder: () => `⌀ ${mm(2 * round)} × ${mm(height)}`,
    cone: () => `⌀ ${mm(2 * low)} to ${mm(2 * high)} × ${mm(height)}`,
    rim: () => `${mm(primitive.width)} wide, ${mm(lengthOf(primitive))} long`,
    bar: () => `${mm(primitive.width)} wide, ${mm(lengthOf(primitive))} long`,
  };
  return words[shape]();
}

class PrimitivesPanel {
  constructor(stage, live) {
    this.stage = stage;
    this.live = live;
    this.known = null;  // what the session has told last, of a surface
    this.shown = null;
    this.sync = new Coalescer(() => this.follow());
    byId('show-primitives').addEventListener('change', () => this.sync.ask());
    live.on('state', () => this.sync.ask());
    // Another scene may state other primitives of the same surface.
    live.on('opened', () => this.forget());
    live.on('connected', (there) => there && this.forget());
  }

  forget() {
    this.known = null;
    if (this.live.state) this.sync.ask();
  }

  async follow() {
    const {object} = this.live.state;
    const surface = object && byId('show-primitives').checked ? object.surface : '';
    if (surface && (!this.known || this.known.surface !== surface)) {
      // What is refused once is not asked for again.
      this.known = await this.live.ask('primitives') || {surface, distances: null, primitives: []};
      // Where the object is another one by now, a state says so.
      if (this.known.surface !== surface) return;
    }
    this.show(surface ? this.known : null);
  }

  show(found) {
    if (found === this.shown) return;
    this.shown = found;
    const primitives = found ? found.primitives : [];
    this.stage.showSolids(primitives.map((primitive, i) => this.solidOf(primitive, i)));
    byId('primitives-list').hidden = primitives.length === 0;
    byId('primitives').replaceChildren(...(primitives.length > 0 ? this.rows(found) : []));
  }

  lookOf(i) {
    return data.palette.solids[i % data.palette.solids.length];
  }

  // In front of the surface of the object where both are in one place.
  solidOf(primitive, i) {
    const made = primitiveSolid({...primitive, X: listOfPose(primitive.pose)}, this.lookOf(i));
    made.traverse(({material}) => {
      if (!material || material.isLineBasicMaterial) return;
      Object.assign(
          material, {polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -4});
    });
    return made;
  }

  rows({primitives, distances}) {
    const head =
        ['shape', 'size', 'half', '95 %'].map((words) => element('th', {scope: 'col'}, words));
    const rows = primitives.map(
        (primitive, i) => this.row(
            [swatch(this.lookOf(i).color), primitive.shape], sizeWords(primitive),
            primitive.distances, primitive.share));
    if (distances) rows.push(this.row(['together'], '', distances, null));
    return [element('thead', {}, element('tr', {}, ...head)), element('tbody', {}, ...rows)];
  }

  row(name, size, distances, share) {
    const within = (key) => distances ? millimetres(distances[key]) : '–';
    const more =
        share === null ? {} : {title: `It explains ${Math.round(100 * share)} % of the surface.`};
    return element(
        'tr', more, element('th', {scope: 'row'}, ...name), element('td', {}, size),
        element('td', {class: 'number'}, within('median')),
        element('td', {class: 'number'}, within('percentile_95')));
  }
}
