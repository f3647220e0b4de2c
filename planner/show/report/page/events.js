// What a simulation saw, line by line.

function showEvents({events}) {
  byId('events').hidden = !events;
  if (!events) return;
  fill('event-list', ...events.map((line) => element('li', {}, line)));
}
