// What a simulation saw, line by line.

function showHappenings({happened}) {
  byId('happenings').hidden = !happened;
  if (!happened) return;
  fill('happened', ...happened.map((line) => element('li', {}, line)));
}
