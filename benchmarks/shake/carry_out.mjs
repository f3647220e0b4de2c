// Carries out the grasps that `carry_out --write FOLDER` wrote, in the newest MuJoCo:
//
//   npm install --prefix DIR @mujoco/mujoco
//   node carry_out.mjs DIR FILE...
//
// For each hand and list of grasps: how many survive here, how many did in the MuJoCo that
// carry_out is linked with, for how many both say the same, and for how many closing on a free
// object (free_grasps) said the same as this one. A line for each grasp that the two tell apart.
// The hand is moved and closed as in mujoco_world.cpp and sim/motion/dynamic_grasp/closing.cpp,
// where the reasons stand.
import {readFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const baseMass = 1e4;     // kg
const baseInertia = 1e2;  // kg m^2
const gearImpedance = 0.9999;
const slow = 0.05;
const stopped = 0.05;    // s
const longestTouch = 1;  // s

const [folder, ...files] = process.argv.slice(2);
if (!folder || files.length === 0) {
  console.error('carry_out.mjs DIR FILE...');
  process.exit(2);
}
const load = await import(pathToFileURL(resolve(folder, 'node_modules/@mujoco/mujoco/mujoco.js')));
const mujoco = await load.default();

const objectTypes = {
  body: mujoco.mjtObj.mjOBJ_BODY.value,
  joint: mujoco.mjtObj.mjOBJ_JOINT.value,
  key: mujoco.mjtObj.mjOBJ_KEY.value,
};
const freeJoint = mujoco.mjtJoint.mjJNT_FREE.value;
const noBias = mujoco.mjtBias.mjBIAS_NONE.value;
const weld = mujoco.mjtEq.mjEQ_WELD.value;

// What each degree of freedom does (class Closing).
class Closing {
  constructor(dofs, {first, waits, effort}) {
    const staged = first.length > 0;
    this.motions = dofs.map((dof, d) => ({
                              velocity: dof.velocity,
                              stage: staged && !first.includes(d) ? 1 : 0,
                              touched: false,
                              still: 0,
                            }));
    this.waits = waits;
    this.part = effort;
    this.stages = staged ? 2 : waits || effort !== 1 ? 1 : 0;
    this.stage = 0;
    this.touchedFor = 0;
  }

  get isFull() {
    return this.stage === this.stages;
  }

  look(touches, rates, time) {
    let ended = true;
    let any = false;
    this.motions.forEach((motion, d) => {
      if (motion.velocity === 0 || motion.stage > this.stage) return;
      motion.touched ||= touches[d];
      motion.still =
          Math.abs(rates[d]) < slow * Math.abs(motion.velocity) ? motion.still + time : 0;
      any ||= motion.touched;
      ended &&= motion.touched || motion.still >= stopped;
    });
    if (any) this.touchedFor += time;
    if (!ended && this.touchedFor < longestTouch) return;
    ++this.stage;
    this.touchedFor = 0;
  }

  effort(d) {
    const motion = this.motions[d];
    if (motion.velocity === 0) return 0;
    if (this.isFull) return 1;
    if (this.waits && motion.touched) return 0;
    return motion.stage > this.stage ? 0 : this.part;
  }
}

class World {
  constructor(carried) {
    // The base is moved by itself, not by its weld. (Its switch in the model can't be read here.)
    const mjcf = carried.mjcf.replace('<weld ', '<weld active="false" ');
    this.model = mujoco.MjModel.from_xml_string(mjcf);
    this.data = new mujoco.MjData(this.model);
    const {model} = this;
    this.moves = carried.moves;
    this.base = this.findBase();
    this.object = this.findObject();
    this.makeBaseHeavy();
    this.grasp = this.id('key', 'grasp');
    this.pregrasp = this.id('key', 'pregrasp');
    this.efforts = new Array(model.njnt).fill(1);
    this.held = new Array(model.njnt).fill(0);
    this.locks = carried.locks.map((lock) => ({...lock, joint: this.id('joint', lock.joint)}));
    for (const {joint} of this.locks) {
      const width = model.jnt_solimp.length / model.njnt;
      model.jnt_solimp.fill(gearImpedance, width * joint, width * joint + 2);
    }
    for (const dof of this.moves.dofs) {
      for (const joint of dof.joints) joint.id = this.id('joint', joint.name);
    }
    this.dofsOfBody = new Map(
        Object.entries(this.moves.links).map(([name, dofs]) => [this.id('body', name), dofs]));
    this.start();
  }

  delete() {
    this.data.delete();
    this.model.delete();
  }

  id(type, name) {
    const id = mujoco.mj_name2id(this.model, objectTypes[type], name);
    if (id < 0) throw new Error(`no ${type} named ${name}`);
    return id;
  }

  findBase() {
    const {model} = this;
    const e = Array.from(model.eq_type).indexOf(weld);
    return model.eq_obj2id[e];
  }

  findObject() {
    const {model} = this;
    const j = Array.from(model.jnt_type)
                  .findIndex((type, k) => type === freeJoint && model.jnt_bodyid[k] !== this.base);
    return model.jnt_bodyid[j];
  }

  makeBaseHeavy() {
    const {model, base} = this;
    model.body_mass[base] = baseMass;
    model.body_inertia.fill(baseInertia, 3 * base, 3 * base + 3);
    model.body_ipos.fill(0, 3 * base, 3 * base + 3);
    model.body_iquat.set([1, 0, 0, 0], 4 * base);
  }

  start() {
    const {model, data} = this;
    const meanInertia = model.stat.meaninertia;
    mujoco.mj_setConst(model, data);
    model.stat.meaninertia = meanInertia;
    mujoco.mj_resetDataKeyframe(model, data, this.grasp);
    for (let j = 0; j < model.njnt; ++j) {
      if (model.jnt_type[j] === freeJoint) continue;
      const q = model.jnt_qposadr[j];
      data.qpos[q] = model.key_qpos[this.pregrasp * model.nq + q];
    }
    mujoco.mj_forward(model, data);
    this.begin = this.position(this.base);
    this.turn = Array.from(data.xquat.slice(4 * this.base, 4 * this.base + 4));
    this.at = this.begin;
    this.velocity = [0, 0, 0];
  }

  position(body) {
    return Array.from(this.data.xpos.slice(3 * body, 3 * body + 3));
  }

  // Of the object's centre of mass, in the world.
  height() {
    const {model, data, object} = this;
    const at = model.jnt_qposadr[model.body_jntadr[object]];
    const [, , z, w, i, j, k] = data.qpos.subarray(at, at + 7);
    const [x, y, up] = model.body_ipos.subarray(3 * object, 3 * object + 3);
    return z + 2 * (i * k - w * j) * x + 2 * (j * k + w * i) * y + (1 - 2 * (i * i + j * j)) * up;
  }

  setEffort(joint, part) {
    if (part === 0 && this.efforts[joint] > 0) {
      this.held[joint] = this.data.qpos[this.model.jnt_qposadr[joint]];
    }
    this.efforts[joint] = part;
  }

  drive(closing) {
    this.moves.dofs.forEach((dof, d) => {
      if (dof.velocity === 0) return;
      for (const joint of dof.joints) this.setEffort(joint.id, closing.effort(d));
    });
  }

  // One step, at the end of which the base is at the position.
  stepTo(position) {
    const {model, data, base} = this;
    const h = model.opt.timestep;
    const next = position.map((p, k) => (p - this.at[k]) / h);
    const {qpos, qvel} = data;
    qpos.set([...this.at, ...this.turn], this.freeAddress(model.jnt_qposadr));
    qvel.set([...this.velocity, 0, 0, 0], this.freeAddress(model.jnt_dofadr));
    for (let j = 0; j < model.njnt; ++j) {
      if (model.jnt_type[j] === freeJoint || this.efforts[j] > 0) continue;
      qpos[model.jnt_qposadr[j]] = this.held[j];
      qvel[model.jnt_dofadr[j]] = 0;
    }
    for (let a = 0; a < model.nu; ++a) {
      const motor = model.actuator_biastype[a] === noBias;
      const part = motor ? this.efforts[model.actuator_trnid[2 * a]] : 1;
      data.ctrl[a] = part * model.key_ctrl[this.grasp * model.nu + a];
    }
    const force =
        next.map((v, k) => baseMass * ((v - this.velocity[k]) / h - model.opt.gravity[k]));
    data.xfrc_applied.set([...force, 0, 0, 0], 6 * base);
    mujoco.mj_step(model, data);
    this.followLocked();
    this.at = position;
    this.velocity = next;
  }

  freeAddress(addresses) {
    return addresses[this.model.body_jntadr[this.base]];
  }

  followLocked() {
    const {model, data} = this;
    for (const {joint, closing} of this.locks) {
      const range = model.jnt_range.subarray(2 * joint, 2 * joint + 2);
      const q = Math.min(Math.max(data.qpos[model.jnt_qposadr[joint]], range[0]), range[1]);
      range[closing > 0 ? 0 : 1] = q;
    }
  }

  // Of each degree of freedom, whether a link that it moves presses on the object.
  touches() {
    const {model, data} = this;
    const touches = this.moves.dofs.map(() => false);
    const contacts = data.contact;
    const force = new mujoco.DoubleBuffer(6);
    for (let c = 0; c < contacts.size(); ++c) {
      const contact = contacts.get(c);
      const bodies = [contact.geom1, contact.geom2].map((geom) => model.geom_bodyid[geom]);
      contact.delete();
      if (!bodies.includes(this.object)) continue;
      const dofs = this.dofsOfBody.get(bodies.find((body) => body !== this.object));
      if (!dofs) continue;
      mujoco.mj_contactForce(model, data, c, force);
      if (force.GetView()[0] > 0)
        for (const d of dofs) touches[d] = true;
    }
    force.delete();
    contacts.delete();
    return touches;
  }

  rates() {
    const {model, data} = this;
    return this.moves.dofs.map(({joints}) => joints.reduce((fastest, {id, ratio}) => {
      const rate = data.qvel[model.jnt_dofadr[id]] / ratio;
      return Math.abs(rate) > Math.abs(fastest) ? rate : fastest;
    }, 0));
  }
}

// Why the grasp failed; '' if it did not.
function failure(carried) {
  const world = new World(carried);
  try {
    for (const phase of carried.phases) {
      const closing = new Closing(carried.moves.dofs, carried.strategy);
      if (phase.closes) world.drive(closing);
      const z = world.height();
      let lowest = 0;
      let rise = 0;
      for (const offset of phase.offsets) {
        const time = world.data.time;
        world.stepTo(world.begin.map((p, k) => p + offset[k]));
        // MuJoCo begins again from the start where its numbers go wild.
        if (!(world.data.time > time)) return 'unstable';
        if (phase.closes && !closing.isFull) {
          closing.look(world.touches(), world.rates(), world.model.opt.timestep);
          world.drive(closing);
        }
        rise = world.height() - z;
        lowest = Math.min(lowest, rise);
      }
      if (-lowest > phase.most_dropped) return 'dropped';
      if (phase.least_rise > 0 && rise < phase.least_rise) return 'did not rise';
    }
    return '';
  } finally {
    world.delete();
  }
}

const tallies = new Map();
for (const file of files) {
  const carried = JSON.parse(readFileSync(file, 'utf8'));
  const of = `${carried.hand} ${carried.of}`;
  const tally = tallies.get(of) ?? {grasps: 0, survived: 0, linked: 0, same: 0, agreed: 0};
  tallies.set(of, tally);
  const why = failure(carried);
  const survived = why === '';
  ++tally.grasps;
  tally.survived += survived;
  tally.linked += carried.survived;
  tally.same += survived === carried.survived;
  tally.agreed += survived === carried.predicted;
  if (survived !== carried.survived) {
    console.log(
        `  ${of} ${carried.object} ${carried.rank}: ${why || 'survives'} here, ` +
        `${carried.survived ? 'survives' : 'fails'} in the other`);
  }
}
for (const [of, {grasps, survived, linked, same, agreed}] of tallies) {
  console.log(
      `${of}: ${survived} of ${grasps} survive (${linked} in the other, ${same} the ` +
      `same), ${agreed} agreed with free_grasps`);
}
