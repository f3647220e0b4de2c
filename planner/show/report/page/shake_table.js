// What shaking showed of a grasp: a row for each test of the protocol.

const shakeMeanings = {
  survived: 'survived',
  moved: 'the object moved too far in the hand',
  turned: 'the object turned too far in the hand',
  dropped: 'the object sank too far',
  not_lifted: 'the object did not rise',
  lost_contact: 'no link touches the object any more',
  not_released: 'the object did not fall from the open hand',
  not_simulated: 'the simulation could not go on',
};

// The farthest of all phases; motions in the hand count from the beginning of each phase.
function farthest(test, quantity) {
  return Math.max(0, ...test.phases.map((phase) => phase[quantity]));
}

function endWords(test) {
  const meaning = shakeMeanings[test.outcome] || test.outcome;
  return test.outcome === 'survived' ? meaning :
                                       `${meaning}, after ${numberText(test.failed_at)} s`;
}

function slipWords({first_slip: slip}) {
  return slip ? `${slip.link}, ${numberText(slip.time)} s` : 'none';
}

function shakeColumns(tests) {
  const columns = [
    ['test', false, (test) => test.name],
    ['end', false, endWords],
    ['moved (mm)', true, (test) => (1000 * farthest(test, 'moved')).toFixed(2)],
    ['turned (°)', true, (test) => (180 / Math.PI * farthest(test, 'turned')).toFixed(2)],
    ['first to slip', false, slipWords],
  ];
  if (tests.some((test) => test.largest_pull !== undefined)) {
    columns.push([
      'largest pull (m/s²)', true,
      (test) => test.largest_pull === undefined ? '' : numberText(test.largest_pull)
    ]);
  }
  return columns;
}

function showShake({shake}) {
  byId('shaken').hidden = !shake;
  if (!shake) return;
  const pull = shake.largest_pull === undefined ?
      '' :
      ` In its weakest direction it bears a pull of ${shake.holds ? 'at least ' : ''}${
          numberText(shake.largest_pull)} m/s².`;
  fill(
      'shaken-words',
      `Protocol ${shake.protocol}: ${shake.survived} of ${shake.of} tests survived.${pull}`);
  const columns = shakeColumns(shake.tests);
  const cell = (tag, [, number], text) =>
      element(tag, number ? {class: 'number'} : {}, String(text));
  fill(
      'shakes', element('tr', {}, ...columns.map((column) => cell('th', column, column[0]))),
      ...shake.tests.map(
          (test) => element(
              'tr', {'data-outcome': test.outcome},
              ...columns.map((column) => cell('td', column, column[2](test))))));
}
