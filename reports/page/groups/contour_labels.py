# SPDX-License-Identifier: Apache-2.0
"""Places for the labels of a map's contours. A place is a pair of numbers from 0 to 1, along the axes of the map."""
import math

# Levels in per cent; those that should get a label first come first.
LEVELS = (0.0, -10.0, 10.0, -20.0, 20.0, -5.0, 5.0, -30.0, 30.0, -50.0, 50.0, -2.0, 2.0, -70.0, 70.0)
WIDTH, HEIGHT = 0.15, 0.085  # the room of a label
LEAST_ROOM = 1.2  # the least distance of its middle from other labels, in sizes of a label
EDGE_WIDTH, EDGE_HEIGHT = 0.09, 0.06  # the least distance of its middle from the map's edge


def crossings(values, level):
    """The places where the map crosses the level, by linear interpolation between neighbouring values."""
    across, up = len(values) - 1, len(values[0]) - 1
    for i in range(across + 1):
        for j in range(up + 1):
            here = values[i][j] - level
            for di, dj in ((1, 0), (0, 1)):
                if i + di <= across and j + dj <= up:
                    beside = values[i + di][j + dj] - level
                    if (here < 0) != (beside < 0):
                        part = here / (here - beside)
                        yield (i + part * di) / across, (j + part * dj) / up


def distance(a, b):
    """The distance of two places in sizes of a label: below 1 their labels would touch."""
    return max(abs(a[0] - b[0]) / WIDTH, abs(a[1] - b[1]) / HEIGHT)


def is_clear(place, taken):
    return all(distance(place, other) > 1 for other in taken)


def labels_of(values, taken):
    """The level and the place of each label, clear of each other and of the places that are taken. Of two places with much
    room the one nearer to the middle is better."""
    labels, filled = [], list(taken)
    for level in LEVELS:
        best, chosen = LEAST_ROOM, None
        for place in crossings(values, level):
            if min(place[0], 1 - place[0]) < EDGE_WIDTH or min(place[1], 1 - place[1]) < EDGE_HEIGHT:
                continue
            room = min((distance(place, other) for other in filled), default=1e9)
            worth = min(room, 4) - 0.2 * math.hypot(place[0] - 0.5, place[1] - 0.5)
            if room > LEAST_ROOM and worth > best:
                best, chosen = worth, place
        if chosen:
            labels.append((level, chosen))
            filled.append(chosen)
    return labels
