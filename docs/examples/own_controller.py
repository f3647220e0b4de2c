"""A controller of one's own: an arm that waves with one joint and holds the others still.

    ./run python docs/examples/own_controller.py
"""

import numpy as np
import numpy.typing as npt

from prehend import dynamics

Floats = npt.NDArray[np.float64]
START = np.array([0.2, -1.2, 1.4, 0.3, 0.7, 0.1])


def wave(time: float) -> Floats:
    """Where the joints should be: the third one swings by 0.3 rad, once in two seconds."""
    wanted = START.copy()
    wanted[2] += 0.15 * (1.0 - np.cos(np.pi * time))
    return wanted


def largest_error(controller: dynamics.Controller, world: dynamics.World) -> float:
    """How far the arm is from the wave at most, in two seconds [rad]."""
    errors = []

    def watch(time: float, now: dynamics.World) -> bool:
        errors.append(np.abs(now.robots[0].positions - wave(time)).max())
        return False  # go on

    run = dynamics.run_controlled(world.copy(), controller, seconds=2.0, stops=watch)
    assert run.outcome == "finished", run
    return float(max(errors))


world = dynamics.World()
arm = world.add_robot("ur5e", positions=START)
gains = dynamics.critically_damped(arm, 3.0)  # settle at 3 Hz


def feedback(state: dynamics.ControlState) -> Floats:
    """Efforts from where the arm is and how fast it moves. Any function of the state will do."""
    error = wave(state.time) - state.positions
    efforts: Floats = gains.stiffness * error - gains.damping * state.rates
    return efforts


weight = dynamics.gravity_compensation()
print(f"feedback alone:       {largest_error(dynamics.sum_of(feedback), world):.4f} rad")
print(f"with its weight held: {largest_error(dynamics.sum_of(weight, feedback), world):.4f} rad")
print(f"computed torque:      {largest_error(dynamics.computed_torque(arm, wave), world):.6f} rad")
