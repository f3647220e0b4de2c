// The grasps of a plan as a table: sorted by its headings, shown by a click on a row or its rank.

// `of`: the value that is sorted by, null where it is not known; columns of nothing but these are
// left out.
const resultColumns = [
  {name: 'rank', words: 'rank', of: ({rank}) => rank},
  {name: 'epsilon', words: 'ε', of: ({epsilon}) => epsilon, falls: true},
  {name: 'volume', words: 'volume', of: ({volume}) => volume ?? null, falls: true, digits: 2},
  {
    name: 'weight',
    words: 'weight [N]',
    of: ({weight}) => weight ?? null,
    title: 'largest normal force that holds the weight, of grasps that were shown',
  },
  {name: 'path', words: 'path [s]', of: ({path}) => path ?? null},
  {name: 'moves', words: 'moves', of: ({moves}) => moves ?? null, title: 'where the hand moves'},
];

// Those without a value come last, whichever way the others go.
function comparedBy({of}, descending) {
  return (a, b) => {
    const [x, y] = [of(a), of(b)];
    if (x === null || y === null) return (x === null) - (y === null) || a.rank - b.rank;
    const order = x < y ? -1 : x > y ? 1 : 0;
    return (descending ? -order : order) || a.rank - b.rank;
  };
}

class ResultsTable {
  // `show(grasp)` and `play(grasp)` are told which one somebody has chosen.
  constructor(table, {show, play}) {
    this.table = table;
    this.show = show;
    this.play = play;
    this.grasps = [];
    this.current = 0;  // the rank of the grasp in hand; 0: none
    this.order = {column: resultColumns[0], descending: false};
    table.addEventListener('click', (event) => this.click(event));
    table.addEventListener('keydown', (event) => this.key(event));
  }

  // `grasps`: each with its rank.
  set(grasps, current) {
    this.grasps = grasps;
    this.current = current;
    this.draw();
  }

  draw() {
    const focused = this.table.contains(document.activeElement) && document.activeElement.dataset;
    const columns = resultColumns.filter(({of}) => this.grasps.some((grasp) => of(grasp) !== null));
    const {column, descending} = this.order;
    const sorted = [...this.grasps].sort(comparedBy(column, descending));
    // One row is reached by Tab, the others from it by arrows.
    const reached = sorted.some(({rank}) => rank === this.current) ? this.current :
        sorted.length > 0                                          ? sorted[0].rank :
                                                                     0;
    this.table.replaceChildren(
        element('thead', {}, element('tr', {}, ...columns.map((one) => this.heading(one)))),
        element('tbody', {}, ...sorted.map((grasp) => this.row(grasp, columns, reached))));
    this.table.hidden = sorted.length === 0;
    if (!focused) return;
    const again =
        focused.sort ? `[data-sort="${focused.sort}"]` : `[data-grasp="${focused.grasp}"]`;
    const node = this.table.querySelector(again);
    if (node) node.focus({preventScroll: true});
  }

  heading(column) {
    const {name, words, title} = column;
    const way = column !== this.order.column ? 'none' :
        this.order.descending                ? 'descending' :
                                               'ascending';
    return element(
        'th', {scope: 'col', 'aria-sort': way},
        element('button', {type: 'button', 'data-sort': name, ...(title ? {title} : {})}, words));
  }

  row(grasp, columns, reached) {
    const {rank} = grasp;
    const cells = columns.map((column) => {
      if (column.name === 'rank') return this.rankCell(rank, reached);
      const value = column.of(grasp);
      if (typeof value === 'string') return element('td', {}, value);
      const text = value === null ? '' :
          column.name === 'path'  ? value.toFixed(1) :
                                    numberText(value, column.digits || 3);
      const play = column.name === 'path' && value !== null ? this.playButton(rank) : null;
      return element('td', {class: 'number', 'data-cell': column.name}, text, play);
    });
    return element(
        'tr', {'data-rank': rank, ...(rank === this.current ? {'aria-current': 'true'} : {})},
        ...cells);
  }

  rankCell(rank, reached) {
    const words = {'aria-label': `show grasp ${rank}`, tabindex: rank === reached ? 0 : -1};
    return element(
        'th', {scope: 'row'},
        element('button', {type: 'button', 'data-grasp': rank - 1, ...words}, String(rank)));
  }

  playButton(rank) {
    return element(
        'button',
        {type: 'button', 'data-play': rank, 'aria-label': `play the path of grasp ${rank}`}, '▶');
  }

  click({target}) {
    const heading = target.closest('[data-sort]');
    const row = target.closest('tr[data-rank]');
    if (heading) {
      this.sort(heading.dataset.sort);
    } else if (row) {
      const grasp = this.grasps.find(({rank}) => rank === Number(row.dataset.rank));
      (target.closest('[data-play]') ? this.play : this.show)(grasp);
    }
  }

  // Best first; the same heading again turns it round.
  sort(name) {
    const column = resultColumns.find((one) => one.name === name);
    const same = column === this.order.column;
    this.order = {column, descending: same ? !this.order.descending : Boolean(column.falls)};
    this.draw();
  }

  // Arrows go from row to row instead of moving what is selected in the scene.
  key(event) {
    const buttons = [...this.table.querySelectorAll('[data-grasp]')];
    const at = buttons.indexOf(event.target);
    const next = {
      ArrowDown: at + 1,
      ArrowUp: at - 1,
      Home: 0,
      End: buttons.length - 1,
    }[event.key];
    if (at < 0 || next === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    if (buttons[next]) buttons[next].focus();
  }
}
