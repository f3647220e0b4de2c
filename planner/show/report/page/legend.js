// What the colours, words and numbers mean, and what the run was.

function simplifiedWords(mesh) {
  return mesh.simplified_from ? `; drawn simplified from ${mesh.simplified_from} triangles` : '';
}

function legendRows() {
  const looks = data.palette;
  const rows = [];
  if (data.scene) {
    rows.push(
        [
          [looks.object.color], 'object',
          'what is grasped, seen through' + simplifiedWords(data.scene.object.mesh)
        ],
        [[looks.hard.color, looks.rubber.color], 'hand', 'light links are hard, dark ones rubber']);
    if (data.scene.arm) rows.push([[looks.arm.color], 'arm', 'what carries the hand']);
    if (data.scene.obstacles.length > 0)
      rows.push([[looks.obstacle.color], 'obstacles', 'what stands in the way']);
    rows.push([
      [looks.primitive.color], 'primitive',
      'the box, sphere or cylinder that the grasp was made from' +
          (data.distances ?
               `; ${distanceWords(data.distances, 'the whole surface')} of the nearest` :
               '')
    ]);
  }
  rows.push(
      [
        [looks.contact.color], 'contact',
        'where hand and object touch; the cone holds the forces that friction allows, as wide as the friction'
      ],
      [
        [looks.weakest.color], 'weakest',
        'the disturbance that the grasp resists least: the arrow is its force, the ring its torque'
      ],
      ...(data.grasps.some((grasp) => grasp.motion && grasp.motion.forces) ? [[
        [looks.force.color], 'force',
        'on the object in a contact; the longer the larger, its tip is where it acts'
      ]] :
                                                                             []),
      [[looks.center.color], 'centre of mass', 'torques are taken about it'],
      [looks.axes, 'frames', 'x, y and z axes of the object and of the hand'],
      [
        [looks.wrench_space.color], 'wrench space',
        'what the contacts can exert with unit force: forces where there is no torque, torques where there is no force. Forces are parts of the contact force, torques parts of it times r'
      ],
      [[looks.epsilon_ball.color], 'ε ball', 'the largest ball inside the wrench space']);
  const meanings = [
    [
      'ε (epsilon)',
      'radius of that ball, from 0 to 1: the grasp resists every disturbance smaller than ε times the contact force (with torques over r). 0: it does not hold. The larger the better'
    ],
    [
      'volume',
      'of the wrench space in its six dimensions: how much the grasp resists in all directions together'
    ],
    [
      'times the weight',
      'how much heavier the object could be before the drives of the hand, with the efforts in its file, or friction let it go; at worst: in the worst of 42 attitudes'
    ],
    [
      'robust ε',
      'ε over samples in which the object, the contacts and the friction are off by a little: mean, and what 95 % of the samples reach'
    ],
    ['ε without it', 'of the other contacts alone: the smaller, the more the grasp needs this one'],
    [
      'r', `largest distance of the object from its centre of mass, ${numberText(1000 * radius)} mm`
    ],
    ['units', 'lengths in mm, forces in N, torques in N m; up is +z of the world'],
  ];
  return rows.map(([swatches, name, text]) => [[...swatches.map(swatch), name], text])
      .concat(meanings.map(([name, text]) => [[name], text]));
}

function showLegend() {
  fill(
      'meanings',
      ...legendRows().flatMap(
          ([term, text]) => [element('dt', {}, ...term), element('dd', {}, text)]));
  fill(
      'facts',
      ...data.facts.map(
          ([name, value]) =>
              element('tr', {}, element('th', {scope: 'row'}, name), element('td', {}, value))));
}
