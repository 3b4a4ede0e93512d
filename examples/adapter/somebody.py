"""A decoder of the paper's array that somebody wrote. It knows nothing of the protocol."""

# GF(4): sums are XOR; to multiply elements that are not 0, add their logarithms.
LOG, EXP = {1: 0, 2: 1, 3: 2}, [1, 2, 3]


def times(a, b):
    return EXP[(LOG[a] + LOG[b]) % 3] if a and b else 0


SEQUENCE = [0, 0, 0, 1]
while len(SEQUENCE) < 255:
    s = SEQUENCE[-4:]
    SEQUENCE.append(times(3, s[0]) ^ times(2, s[1]) ^ s[2])

CELLS = [[0] * 17 for _ in range(15)]
for i, symbol in enumerate(SEQUENCE):
    CELLS[i % 15][i % 17] = symbol


def symbol_at(row, column):
    return CELLS[row % 15][column % 16]


def number_of(cells):
    a, b, c, d = cells
    return 64 * a + 16 * b + 4 * c + d
