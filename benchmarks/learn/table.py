"""The table of docs/how-to/learning.md, from the lines of `learn_benchmark compare`.

    python3 table.py LINES...

For known and unknown hands, and numbers of trials T, how many times fewer trials the search with a
model took to come within 1 % of what the search without it has after T trials (above 1: fewer;
twice the trials of the search where it did not):

searches   of each search alone: median, the tenth and the ninetieth part, median of each seed, and
           the part that took more than 1.1 times as many
curves     of curves of the best epsilon that are averaged over the seeds, or over the seeds and
           hands of an object: median over the curves, and the part that took more than 1.1 times
           as many; epsilons count in parts of the largest without the model
all        of the one curve that is averaged over all searches, with its epsilons
"""

import statistics
import sys

TRIALS = [25, 50, 100, 200, 400]
MOST = 400
WITHIN = 0.01


def curve(words, scale):
    """The best epsilon after 0 ... MOST trials, in units of `scale`."""
    found = [0.0] * (MOST + 1)
    pairs = [(int(words[i]), float(words[i + 1])) for i in range(0, len(words), 2)]
    best = 0.0
    for trial in range(1, MOST + 1):
        while pairs and pairs[0][0] <= trial:
            best = pairs.pop(0)[1] / scale
        found[trial] = best
    return found


def read(files):
    """(known or unknown, object, hand, seed): curves without and with a model."""
    searches = {}
    for file in files:
        with open(file, encoding="utf-8") as lines:
            for line in lines:
                words = line.split()
                if "with" not in words:
                    continue
                split = words.index("with")
                without = words[5:split]
                scale = float(without[-1])
                searches[tuple(words[:4])] = (curve(without, scale),
                                              curve(words[split + 1:], scale))
    return searches


def mean(curves):
    return [sum(values) / len(curves) for values in zip(*curves)]


def trials_to_reach(found, epsilon):
    return next((t for t, best in enumerate(found) if best >= epsilon), 2 * MOST)


def fewer(pair, trials):
    """How many times fewer trials; None where nothing is found without a model."""
    without, with_model = pair
    epsilon = (1 - WITHIN) * without[trials] - 1e-9
    if epsilon <= 0:
        return None
    return trials_to_reach(without, epsilon) / trials_to_reach(with_model, epsilon)


def worse(ratios):
    return sum(ratio < 1 / 1.1 for ratio in ratios) / len(ratios)


def averaged(searches, length):
    """Pairs of curves averaged over what has the same first words."""
    groups = {}
    for key, pair in searches.items():
        groups.setdefault(key[1:length], []).append(pair)
    return [tuple(mean(side) for side in zip(*pairs)) for pairs in groups.values()]


def ratios_of(pairs, trials):
    return [ratio for pair in pairs if (ratio := fewer(pair, trials)) is not None]


def print_searches(searches, trials):
    ratios = sorted(ratios_of(searches.values(), trials))
    seeds = sorted({key[3] for key in searches})
    medians = [statistics.median(ratios_of([p for k, p in searches.items() if k[3] == seed], trials))
               for seed in seeds]
    print(f"| {trials} | {statistics.median(ratios):.2f} | {ratios[len(ratios) // 10]:.2f}"
          f" | {ratios[9 * len(ratios) // 10]:.2f} | {', '.join(f'{m:.2f}' for m in medians)}"
          f" | {100 * worse(ratios):.0f} %", end="")


def print_curves(searches, trials):
    for length in (3, 2):
        ratios = ratios_of(averaged(searches, length), trials)
        print(f" | {statistics.median(ratios):.2f}, {100 * worse(ratios):.0f} %", end="")
    without, with_model = averaged(searches, 1)[0]
    took = trials_to_reach(with_model, without[trials])
    print(f" | {without[trials]:.3f}, {with_model[trials]:.3f}, {trials / took:.1f} |")


def main():
    everything = read(sys.argv[1:])
    for hand in ("known", "unknown"):
        searches = {key: pair for key, pair in everything.items() if key[0] == hand}
        print(f"{hand}: {len(searches)} searches, {len(averaged(searches, 2))} objects")
        for trials in TRIALS:
            print_searches(searches, trials)
            print_curves(searches, trials)


if __name__ == "__main__":
    main()
