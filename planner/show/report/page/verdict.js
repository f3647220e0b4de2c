// How good a grasp is, and where it is weakest, in words and numbers.

const exampleForce = 10;  // N

// "Where it is weakest": the smallest disturbance that breaks the grasp, for contacts that press
// with exampleForce.
function weakestWords(grasp) {
  const force = vectorOf(grasp.weakest_force)
                    .transformDirection(X_WO)
                    .multiplyScalar(exampleForce * vectorOf(grasp.weakest_force).length());
  const torque =
      vectorOf(grasp.weakest_torque)
          .transformDirection(X_WO)
          .multiplyScalar(exampleForce * radius * vectorOf(grasp.weakest_torque).length());
  const parts = [];
  if (force.length() > 0.05 * exampleForce * grasp.epsilon[1]) {
    parts.push(`a push of ${numberText(force.length(), 2)} N (${directionWords(force)})`);
  }
  if (torque.length() > 0.05 * exampleForce * radius * grasp.epsilon[1]) {
    parts.push(
        `a twist of ${numberText(torque.length(), 2)} N m (about ${directionWords(torque)})`);
  }
  return `Weakest (purple): ${
             parts.join(' together with ')} at the centre of mass breaks it, with ` +
      `${data.unit_force} ${exampleForce} N.`;
}

function shareWords(grasp) {
  if (!grasp.detail || grasp.detail.links.length === 0 || !grasp.force_closure) return null;
  const links = [...grasp.detail.links].sort((a, b) => a.without - b.without);
  const lost = links.filter((share) => share.without === 0);
  if (lost.length > 0 && lost.length < links.length) {
    return `It does not hold without ${lost.map((share) => share.link).join(', nor without ')}.`;
  }
  if (lost.length > 0) return 'It does not hold without any one of the links that touch.';
  return `It depends most on ${links[0].link}: without it ε is ${numberText(links[0].without)}.`;
}

function verdict(grasp, i) {
  const best = bestGrasp();
  const holds = grasp.force_closure ? 'stable' : 'not_force_closure';
  const color = data.palette.outcomes[grasp.outcome] || data.palette.outcomes[holds];
  const name = grasp.outcome || (grasp.force_closure ? 'force closure' : 'no force closure');
  const known = data.outcomes.find((outcome) => outcome.name === grasp.outcome);
  const line = element(
      'p', {}, element('span', {class: 'badge', color}, name), ' ',
      known ? known.meaning + (grasp.blame ? ': ' + grasp.blame : '') + '. ' : '',
      i === best && data.grasps.length > 1 ? 'The best of these grasps.' : '');
  const weakest =
      grasp.force_closure ? element('p', {class: 'weakest'}, weakestWords(grasp)) : null;
  const share = shareWords(grasp);
  return [line, weakest, share ? element('p', {}, share) : null].filter((part) => part);
}

function bracketText([lower, upper]) {
  const a = numberText(lower, 4);
  const b = numberText(upper, 4);
  return a === b ? a : `${a} to ${b}`;
}

function percentText(part) {
  return `${Math.round(100 * part)} %`;
}

function timesText({strength}) {
  return strength === 'any' ? 'any weight' : `${strength} times the weight`;
}

function weightRows({holds, given, worst}) {
  const squeeze = given.squeeze === null ?
      'no forces of the contacts balance the weight as the object lies' :
      `as the object lies; its weight takes normal forces of ${numberText(given.squeeze)} N in all`;
  return [
    [holds ? 'the hand holds' : 'the hand holds only', timesText(given), squeeze],
    ['and at worst', timesText(worst), 'if gravity pulls from the worst side']
  ];
}

function directionText(weakest) {
  return '(' + weakest.map((part) => numberText(part, 2)).join(', ') + ')';
}

function robustnessRows(
    {samples, held, success, interval, epsilon_mean, spare, weakest, weakness}) {
  const sure = interval.map((part) => Math.round(100 * part)).join(' to ');
  const where = weakest.some((part) => part !== 0) ?
      `before it is lost; weakest where it is off in the direction ${
          directionText(weakest)} of its frame: there ${weakness}` :
      'and perhaps farther, in any direction that was tried';
  return [
    [
      'lifts the object', `${Math.round(100 * success)} of 100 times`,
      'as grasps of such numbers did in simulation'
    ],
    [
      'held in', `${held} of ${samples} trials`,
      `with errors of pose, friction and centre of mass: ${sure} % with a probability of 90 %; ε ${
          numberText(epsilon_mean)} in the mean`
    ],
    ['the object may be off by', `${numberText(1000 * spare)} mm`, where]
  ];
}

// How far the surface is from the primitive that a grasp was made for; empty where it is not known.
function primitiveWords({primitive}) {
  const {distances} = data.primitives[primitive] || {};
  return distances ? `${distanceWords(distances, 'the surface there')} of it` : '';
}

function numberRows(grasp) {
  const rows = [[
    'quality ε', bracketText(grasp.epsilon),
    'the weakest disturbance it gives way to, as part of the contact force'
  ]];
  if (grasp.volume) {
    rows.push(['volume', bracketText(grasp.volume), 'of the space of wrenches it can resist']);
  }
  if (grasp.moved) rows.push(['while it closed', grasp.moved, '']);
  if (grasp.weight) rows.push(...weightRows(grasp.weight));
  if (grasp.robustness) rows.push(...robustnessRows(grasp.robustness));
  if (grasp.detail && grasp.contacts.length > 0) {
    const {robust} = grasp.detail;
    rows.push([
      'robust ε', `${numberText(robust.mean)} mean, ${numberText(robust.percentile_5)} at 5 %`,
      'with the object and the contacts not quite where they were thought to be'
    ]);
    rows.push(['holds then', percentText(robust.force_closure), 'of such samples']);
  }
  rows.push(['contacts', String(grasp.contacts.length), '']);
  if (grasp.origin) rows.push(['comes from', grasp.origin, primitiveWords(grasp)]);
  if (grasp.preshape) rows.push(['preshape', grasp.preshape, 'of the hand as it comes']);
  return rows;
}

function showNumbers(grasp, i) {
  fill('grasp-title', data.grasps.length > 1 ? `Grasp ${i + 1}` : 'The grasp');
  fill('verdict', ...verdict(grasp, i));
  fill(
      'numbers',
      ...numberRows(grasp).map(
          ([name, value, note]) => element(
              'tr', {}, element('th', {scope: 'row'}, name), element('td', {}, value),
              element('td', {class: 'note'}, note))));
}
