// What matters of the grasp in hand, in one line over the stage: it is seen whatever panels show.

// The disturbance that breaks the grasp first, whose size is ε.
function weakestWords({weakest_wrench: {force_object, scaled_torque_object}}) {
  const force = vectorOf(force_object);
  const torque = vectorOf(scaled_torque_object);
  const least = 0.1 * Math.hypot(force.length(), torque.length());
  const inWorld = (v) => directionWords(v.clone().transformDirection(X_WO));
  const parts = [];
  if (force.length() > least) parts.push(`a push ${inWorld(force)}`);
  if (torque.length() > least) parts.push(`a twist about ${inWorld(torque)}`);
  return parts.join(' with ') || '–';
}

class StateBar {
  constructor(live) {
    this.live = live;
    live.on('judged', (found) => this.show(found));
  }

  // `found`: what the grasp panel has asked for; null where the scene cannot be judged.
  show(found) {
    const nothing = {epsilon: '–', weight: '', contacts: '', weakest: this.live.state.problem};
    const words = found ? this.wordsOf(found) : nothing;
    for (const [name, text] of Object.entries(words)) byId(`bar-${name}`).textContent = text;
    const outcome = byId('bar-outcome');
    outcome.textContent = byId('outcome').textContent;
    outcome.style.cssText = byId('outcome').style.cssText;
  }

  wordsOf({quality, weight}) {
    const {outcome, epsilon, contacts} = quality;
    const holds = outcome === 'stable';
    return {
      epsilon: holds ? numberText(epsilon.lower, 4) : '0',
      weight: this.weightWords(weight),
      contacts: contacts.length === 1 ? '1 contact' : `${contacts.length} contacts`,
      weakest: holds ? `weakest: ${weakestWords(quality)}` : '',
    };
  }

  // `weight`: forces that balance it, or null where there is none.
  weightWords(weight) {
    if (!weight) return '';
    if (weight.outcome === 'balanced')
      return `weight held with ${numberText(weight.largest_normal)} N`;
    return weight.outcome === 'impossible' ? 'weight not held' : '';
  }
}
