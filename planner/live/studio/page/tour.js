// A minute for somebody who is here for the first time.

const tourSteps = [
  [
    '#stage',
    'This is the object and, above it, the hand. Drag to turn the view, the wheel zooms, the right ' +
        'button shifts, a double click goes closer to a point.'
  ],
  [
    '#stage',
    'Click the palm of the hand: arrows and rings appear. Drag one, and the hand follows until it ' +
        'touches. Click a finger instead, and each of its joints gets a disc to turn.'
  ],
  [
    '#hand-panel', '“Approach” moves the hand on until it touches, “auto-grasp” closes the fingers.'
  ],
  [
    '#grasp',
    'Here is how well that holds: ε is the smallest disturbance that breaks the grasp, per newton ' +
        'of grip. The two figures are what the contacts can push and twist.'
  ],
  [
    '#plan-panel',
    '“Plan” tries hundreds of grasps. Click a row to see it, “pin” puts one aside to ' +
        'compare it.'
  ],
  [
    '#world-panel',
    'Add objects and obstacles, or drop a mesh anywhere onto the page. Every step ' +
        'can be undone (Ctrl+Z). “?” shows all keys.'
  ],
];

class Tour {
  constructor() {
    byId('tour').addEventListener('click', () => this.begin());
    byId('tour-next').addEventListener('click', () => this.go(this.at + 1));
    byId('tour-end').addEventListener('click', () => this.go(tourSteps.length));
    this.at = tourSteps.length;
  }

  begin() {
    this.go(0);
  }

  go(step) {
    document.querySelectorAll('.pointed').forEach((node) => node.classList.remove('pointed'));
    this.at = step;
    const box = byId('tour-box');
    box.hidden = step >= tourSteps.length;
    if (box.hidden) return;
    const [place, words] = tourSteps[step];
    showPanels(true);
    const fold = document.querySelector(`${place} > details`);
    if (fold) fold.open = true;
    document.querySelector(place).classList.add('pointed');
    byId('tour-words').textContent = `${step + 1} of ${tourSteps.length}. ${words}`;
    byId('tour-next').textContent = step + 1 < tourSteps.length ? 'next' : 'done';
    byId('tour-next').focus();
    document.querySelector(place).scrollIntoView();  // panels are below each other
  }
}
