// The grasps, one after the other, each with a small picture and its most important numbers.

class GraspList {
  constructor(thumbnails) {
    const shown = data.grasps.length;
    const all = data.grasps_in_all;
    const sorted = data.grasps.every((grasp, i) => i === 0 || !isBetter(grasp, data.grasps[i - 1]));
    fill(
        'grasps-title',
        shown === 0     ? 'No grasp holds' :
            all > shown ? `The first ${shown} of ${all} grasps` :
            shown === 1 ? 'One grasp' :
                          `${shown} grasps${sorted ? ', best first' : ''}`);
    const best = bestGrasp();
    this.links = data.grasps.map((grasp, i) => this.entry(grasp, i, i === best));
    fill('list', ...this.links.map((link) => element('li', {}, link)));
    if (thumbnails) {
      for (const canvas of byId('list').querySelectorAll('canvas')) thumbnails.watch(canvas);
    }
  }

  entry(grasp, i, best) {
    const words = grasp.force_closure ? `ε ${numberText(grasp.epsilon[0], 4)}` :
                                        grasp.outcome || 'no force closure';
    const picture = element('canvas', {width: 224, height: 168, 'data-grasp': i});
    picture.hidden = !data.scene;
    return element(
        'a', {href: `#${i + 1}`, 'data-grasp': i}, picture,
        element(
            'div', {}, element('span', {class: 'rank'}, `${i + 1}`),
            best && data.grasps.length > 1 ? element('span', {class: 'best'}, 'best') : null,
            element('div', {}, words), element('small', {}, grasp.preshape || ''),
            element('small', {}, `${grasp.contacts.length} contacts`)));
  }

  select(i) {
    this.links.forEach((link, k) => link.setAttribute('aria-current', String(k === i)));
    this.links[i].scrollIntoView({block: 'nearest', inline: 'nearest'});
  }
}
