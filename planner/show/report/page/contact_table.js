// The contacts of a grasp as a table; pointing at a row highlights that contact wherever it is
// shown.

function contactColumns(grasp) {
  const columns = [['#', true, (contact, i) => i + 1]];
  if (grasp.contacts.some((contact) => contact.link)) {
    columns.push(['link', false, (contact) => contact.link || '']);
  }
  columns.push(
      ['friction', true, (contact) => numberText(contact.mu)],
      ['model', false, (contact) => contact.model.replace('_', ' ')], [
        'position (mm)', false, (contact) => contact.p.map((x) => (1000 * x).toFixed(1)).join(', ')
      ]);
  if (grasp.contacts.some((contact) => contact.gap !== undefined)) {
    columns.push(['gap (mm)', true, (contact) => (1000 * contact.gap).toFixed(3)]);
  }
  if (grasp.detail) {
    columns.push(['ε without it', true, (contact, i) => numberText(grasp.detail.without[i])]);
  }
  return columns;
}

function showContacts(grasp, light) {
  const columns = contactColumns(grasp);
  const cell = (tag, [name, number], text) =>
      element(tag, number ? {class: 'number'} : {}, String(text));
  const head = element('tr', {}, ...columns.map((column) => cell('th', column, column[0])));
  const rows = grasp.contacts.map(
      (contact, i) => element(
          'tr', {
            'data-contact': i,
            onpointerenter: () => light(i),
            onpointerleave: () => light(-1),
          },
          ...columns.map((column) => cell('td', column, column[2](contact, i)))));
  fill('contacts', head, ...rows);
  const links = grasp.detail && grasp.force_closure ? grasp.detail.links : [];
  fill(
      'shares',
      ...links.map(
          (share) => element(
              'p', {class: 'note'},
              `Without ${share.link}: ${
                  share.without > 0 ? `ε ${numberText(share.without)}` : 'does not hold'}`)));
}

function lightRow(i) {
  for (const row of byId('contacts').querySelectorAll('tr[data-contact]')) {
    row.classList.toggle('lit', Number(row.dataset.contact) === i);
  }
}
