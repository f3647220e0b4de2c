"""Plan grasps of a scene of the library, print them, and write the result files.

    ./run python docs/examples/plan_scene.py [SCENE] [FOLDER]
"""

import sys

import prehend
from prehend import planning


def show(progress: planning.Progress) -> None:
    if progress.done % 100 == 0:
        print(f"{progress.stage}: {progress.done} of {progress.total}", file=sys.stderr)


def main() -> None:
    name = sys.argv[1] if len(sys.argv) > 1 else "mug"
    folder = sys.argv[2] if len(sys.argv) > 2 else "out"

    # Compiling prepares the scene for trials; the compiled scene can be used for many plans.
    scene = prehend.compile_scene(prehend.load_scene(name))
    options = prehend.PlanOptions(rank=prehend.options.RankOptions(top=5))
    result = prehend.plan(scene, options, progress=show)

    print("rank  epsilon  contacts  preshape   where it came from")
    for rank, grasp in enumerate(result, 1):
        print(
            f"{rank:4}  {grasp.epsilon:7.4f}  {len(grasp.contacts):8}  "
            f"{grasp.preshape or '-':9}  {grasp.rule}"
        )
    # The number of candidates with each outcome.
    print({outcome: count for outcome, count in result.outcomes.items() if count})

    # poses is an array (N, 4, 4): the poses of the hand's base in the object's frame.
    if len(result):
        print("the best hand is at", result.poses[0, :3, 3].round(3), "m")
    print("wrote", ", ".join(prehend.write_grasps(result, folder, report=False)))


main()
