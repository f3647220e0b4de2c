// Parts that all panels are made of.

function button(words, action, more = {}) {
  return element('button', {type: 'button', onclick: action, ...more}, words);
}

// Shows the panels, or the stage without them.
function showPanels(shown) {
  document.body.classList.toggle('bare', !shown);
  byId('panels-shown').setAttribute('aria-expanded', shown);
}

// Panels fold by their headings, and are next time as they were left.
function rememberFolds() {
  const folded = new Set(JSON.parse(localStorage.getItem('prehend-folded') || '[]'));
  for (const panel of document.querySelectorAll('.column > section')) {
    const fold = panel.querySelector('details');
    fold.open = !folded.has(panel.id);
    fold.addEventListener('toggle', () => {
      folded[fold.open ? 'delete' : 'add'](panel.id);
      localStorage.setItem('prehend-folded', JSON.stringify([...folded]));
    });
  }
}

// A name as a line may break it: after an underscore, not within a word.
function breakable(name) {
  return name.split(/(?<=_)/).flatMap((part, i) => i === 0 ? [part] : [element('wbr'), part]);
}

// A field with its name above it.
function labelled(name, field) {
  return element('label', {class: 'field'}, element('span', {}, name), field);
}

function choice(options, attributes = {}) {
  return element(
      'select', attributes,
      ...options.map(
          (option) => element('option', {value: option.value ?? option}, option.words ?? option)));
}

function numberField(value, attributes = {}) {
  return element('input', {type: 'number', value, step: 'any', ...attributes});
}

// The number in a field, or null where there is none.
function numberIn(field) {
  const value = Number(field.value);
  return field.value.trim() === '' || !Number.isFinite(value) ? null : value;
}

// A slider with a number for one degree of freedom; `change` gets the values that a person sets.
// What is set in one drag of the slider is one gesture.
function sliderRow(name, lower, upper, live, change) {
  const slider = element('input', {
    type: 'range',
    min: lower,
    max: upper,
    step: (upper - lower) / 1000,
    'aria-label': name,
    'data-dof': name,
    onpointerdown: () => live.beginGesture(),
    onpointerup: () => live.endGesture(),
    oninput: () => change(Number(slider.value)),
  });
  const field = numberField(0, {
    'aria-label': `${name}, number`,
    min: lower,
    max: upper,
    onchange: () => {
      const value = numberIn(field);
      if (value !== null) change(value);
    },
  });
  const set = (value) => {
    if (document.activeElement !== field) field.value = Number(value.toFixed(4));
    slider.value = value;
    slider.setAttribute('aria-valuetext', numberText(value, 4));
  };
  return {row: element('li', {}, element('span', {}, ...breakable(name)), slider, field), set};
}

// Replaces the children of a list only where what it shows has changed, so that the focus stays.
function fillChanged(list, key, make) {
  if (list.dataset.key === key) return;
  list.dataset.key = key;
  list.replaceChildren(...make());
}

// Gives a file to the person.
function download(name, content, type = 'text/plain') {
  const blob = content instanceof Blob ? content : new Blob([content], {type});
  const link = element('a', {href: URL.createObjectURL(blob), download: name});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function base64Of(buffer) {
  const bytes = new Uint8Array(buffer);
  let text = '';
  for (let i = 0; i < bytes.length; i += 0x8000) {
    text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  }
  return btoa(text);
}
