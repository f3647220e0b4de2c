// How all candidates ended: a chart of the outcomes, which also chooses the arrows in the scene.

class WhyNot {
  constructor(onChange) {
    this.chosen = new Set();
    data.outcomes.forEach((outcome, i) => {
      if (outcome.count > 0 && outcome.name !== 'stable') this.chosen.add(i);
    });
    byId('why-not').hidden = data.outcomes.length === 0;
    this.onChange = onChange;
    const {rows, in_all} = data.candidates;
    fill(
        'why-note',
        `${in_all} candidates were tried. ` +
            (rows.length < in_all ? `${rows.length} of them, evenly picked, can be shown` :
                                    'They can be shown') +
            ' in the scene as arrows that point the way the hand came.');
    fill('outcomes', this.chart());
    fill('blockers', ...this.blockers());
    fill('advice', ...this.advice());
  }

  // What may help, and how the candidates of each rule ended: of plans without a grasp.
  advice() {
    const parts = [];
    if (data.advice.length > 0) {
      parts.push(
          element('h2', {}, 'What may help'),
          element('ul', {}, ...data.advice.map((words) => element('li', {}, words))));
    }
    if (data.rules.length > 0) {
      const rows = data.rules.map(
          ({rule, outcomes}) => element(
              'tr', {}, element('td', {}, rule),
              element('td', {}, outcomes.map(([name, count]) => `${count} ${name}`).join(', '))));
      parts.push(element('h2', {}, 'By rule'), element('table', {}, ...rows));
    }
    return parts;
  }

  chart() {
    const most = Math.max(1, ...data.outcomes.map((outcome) => outcome.count));
    const chart = element('div', {class: 'chart'});
    data.outcomes.forEach((outcome, i) => {
      if (outcome.count === 0) return;
      const color = data.palette.outcomes[outcome.name];
      const box = element('input', {
        type: 'checkbox',
        'data-outcome': outcome.name,
        onchange: () => this.choose(i, box.checked)
      });
      box.checked = this.chosen.has(i);
      const bar = element('div', {class: 'bar', color, title: outcome.meaning});
      bar.style.width = `${100 * outcome.count / most}%`;
      chart.append(
          element('label', {title: outcome.meaning}, box, swatch(color), outcome.name), bar,
          element('span', {}, String(outcome.count)));
    });
    return chart;
  }

  choose(i, chosen) {
    if (chosen) {
      this.chosen.add(i);
    } else {
      this.chosen.delete(i);
    }
    this.onChange(this.chosen);
  }

  blockers() {
    if (data.blockers.length === 0) return [];
    const most = 12;
    const rows = data.blockers.slice(0, most).map(
        (blocker) => element(
            'tr', {}, element('td', {}, blocker.link), element('td', {}, blocker.by),
            element('td', {}, blocker.outcome),
            element('td', {class: 'number'}, String(blocker.count))));
    const head = element(
        'tr', {},
        ...['link', 'met', 'outcome', 'candidates'].map((name) => element('th', {}, name)));
    const rest = data.blockers.length - most;
    return [
      element('h2', {}, 'What was in the way'), element('table', {}, head, ...rows),
      rest > 0 ? element('p', {class: 'note'}, `and ${rest} more pairs`) : ''
    ];
  }
}
