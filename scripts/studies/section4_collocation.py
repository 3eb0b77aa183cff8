"""The paper's point mass on two cables, solved by Chebyshev collocation: shares nothing with the package but the model.

Both cables are mapped to t = s/L in [0, 1]; the equations of both, their ends' conditions, the meeting of the ends and
the balance of the mass are one nonlinear system, solved by Newton's method. Needs numpy.
"""

import numpy as np

ANCHORS = np.array([[0.0, 0.0], [10.0, 2.0]])  # [m]
AREA = np.pi * 0.01**2
EA = 170e9 * AREA  # [N]
EI = 170e9 * np.pi * 0.01**4 / 4  # [N m^2]
Q = 8050 * 9.81 * AREA  # [N/m]
SIDE = (1, -1)  # cable 1 leads to larger x, cable 2 to smaller


def differentiation(n):
    """Nodes t_0 = 0 ... t_n = 1 and the matrix that differentiates a polynomial given there."""
    x = -np.cos(np.pi * np.arange(n + 1) / n)
    c = np.r_[2, np.ones(n - 1), 2] * (-1.0) ** np.arange(n + 1)
    d = np.outer(c, 1 / c) / (x[:, None] - x[None, :] + np.eye(n + 1))
    return (x + 1) / 2, 2 * (d - np.diag(d.sum(axis=1)))


def straight(lengths):
    """Where two straight inextensible lines meet, below."""
    chord = ANCHORS[1] - ANCHORS[0]
    span = np.hypot(*chord)
    along = (lengths[0] ** 2 - lengths[1] ** 2 + span**2) / (2 * span)
    below = np.sqrt(lengths[0] ** 2 - along**2)
    return ANCHORS[0] + (along * chord + below * np.array([chord[1], -chord[0]])) / span


def catenary_end(h, v, s, ea):
    """The textbook elastic catenary, [6] of the paper, for numbers s or arrays of them."""
    x = h / Q * (np.arcsinh(v / h) - np.arcsinh((v - Q * s) / h)) + h * s / ea
    w = (np.hypot(h, v - Q * s) - np.hypot(h, v)) / Q + (Q * s / 2 - v) * s / ea
    return np.array([x, w])


def catenary(load, lengths, ea=EA):
    """Position of the mass and (H, V_1, V_2)."""
    weight = load + Q * sum(lengths)
    ends = [straight(lengths) - anchor for anchor in ANCHORS]
    slopes = [-w / abs(x) for x, w in ends]
    h = load / sum(slopes)

    def gap(f):
        first = ANCHORS[0] + catenary_end(f[0], f[1], lengths[0], ea)
        return first - ANCHORS[1] - catenary_end(f[0], weight - f[1], lengths[1], ea) * [-1, 1]

    f = np.array([h, h * slopes[0] + Q * lengths[0] / 2])
    for _ in range(60):
        steps = 1e-5 * load * np.eye(2)
        jacobian = np.column_stack([(gap(f + step) - gap(f - step)) / (2e-5 * load) for step in steps])
        change = np.linalg.solve(jacobian, -gap(f))
        f = f + change * min(1, 0.3 * f[0] / np.abs(change).max())
        if np.abs(change).max() < 1e-12 * load:
            break
    else:
        raise RuntimeError(f"catenary: no convergence at {load} N, {lengths} m")
    return ANCHORS[0] + catenary_end(f[0], f[1], lengths[0], ea), np.array([f[0], f[1], weight - f[1]])


class BendingPair:
    """The two bending cables. Unknown: alpha, M, x, w at the nodes of each, then H, V_1, V_2. ea = inf: no stretch."""

    def __init__(self, load, lengths, ea=EA, ei=EI, n=48):
        self.load, self.lengths, self.ea, self.ei = load, lengths, ea, ei
        self.t, self.d = differentiation(n)
        self.m = n + 1

    def guess(self):
        """The catenary, without moments."""
        _, (h, v1, v2) = catenary(self.load, self.lengths, self.ea)
        parts = []
        for length, v in zip(self.lengths, (v1, v2)):
            s = self.t * length
            parts += [np.arctan2(Q * s - v, h), 0 * s, *catenary_end(h, v, s, self.ea)]
        return np.concatenate(parts + [[h, v1, v2]])

    def shape(self, z, k):
        return z[4 * self.m * k : 4 * self.m * (k + 1)].reshape(4, self.m)

    def position(self, z):
        return ANCHORS[0] + self.shape(z, 0)[2:, -1]

    def forces(self, z):
        return z[8 * self.m :]

    def system(self, z):
        """Residuals and their Jacobian."""
        m, size = self.m, len(z)
        residual, jacobian = np.zeros(size), np.zeros((size, size))
        h_at = 8 * m
        for k, length in enumerate(self.lengths):
            at = 4 * m * k
            alpha, moment, _, _ = self.shape(z, k)
            h, v = z[h_at], z[h_at + 1 + k]
            c, sn, hang = np.cos(alpha), np.sin(alpha), Q * self.t * length - v
            e = 1 + (h * c + hang * sn) / self.ea
            shear = h * sn - hang * c
            along = h * c + hang * sn
            # Right-hand sides e g of alpha', M', x', w', and what e and g change by with alpha, M, H and V.
            change_e = {"alpha": -shear / self.ea, "H": c / self.ea, "V": -sn / self.ea}
            sides = [
                (moment / self.ei, {"M": 1 / self.ei}),
                (shear, {"alpha": along, "H": sn, "V": c}),
                (c, {"alpha": -sn}),
                (sn, {"alpha": c}),
            ]
            columns = {"alpha": at, "M": at + m}
            # M(L) = 0 instead of the last equation of alpha; M(0) = x(0) = w(0) = 0 instead of the first ones.
            condition = [(m - 1, at + 2 * m - 1), (0, at + m), (0, at + 2 * m), (0, at + 3 * m)]
            for i, (g, change_g) in enumerate(sides):
                rows = np.arange(at + i * m, at + (i + 1) * m)
                residual[rows] = self.d @ z[rows] - length * e * g
                jacobian[np.ix_(rows, rows)] = self.d
                for name in ("alpha", "M", "H", "V"):
                    change = length * (change_e.get(name, 0) * g + e * change_g.get(name, 0))
                    where = columns[name] + np.arange(m) if name in columns else h_at + (0 if name == "H" else 1 + k)
                    jacobian[rows, where] -= change
                node, variable = condition[i]
                residual[rows[node]] = z[variable]
                jacobian[rows[node]] = 0
                jacobian[rows[node], variable] = 1
        ends = [4 * m * k + 3 * m - 1 for k in (0, 1)]
        chord = ANCHORS[1] - ANCHORS[0]
        residual[h_at] = z[ends[0]] + z[ends[1]] - chord[0]
        residual[h_at + 1] = z[ends[0] + m] - z[ends[1] + m] - chord[1]
        residual[h_at + 2] = (z[h_at + 1] + z[h_at + 2] - Q * sum(self.lengths) - self.load) / self.load
        jacobian[h_at, ends] = 1
        jacobian[h_at + 1, [ends[0] + m, ends[1] + m]] = SIDE
        jacobian[h_at + 2, [h_at + 1, h_at + 2]] = 1 / self.load
        return residual, jacobian

    def solve(self, z=None, turn=0.3, iterations=40):
        """Newton's method, nowhere turning by more than `turn` [rad] in one step. None without convergence."""
        z = self.guess() if z is None else z
        for _ in range(iterations):
            residual, jacobian = self.system(z)
            try:
                change = np.linalg.solve(jacobian, -residual)
            except np.linalg.LinAlgError:
                return None
            largest = max(np.abs(self.shape(change, k)[0]).max() for k in (0, 1))
            if not np.isfinite(largest):
                return None
            z = z + change * min(1, turn / largest)
            if largest < 1e-12:
                return z
        return None

    def falling_directions(self, z, links=150):
        """Number of directions in the plane in which the potential energy falls (stretch neglected): 0 is stable.

        Links of equal length with springs between them; both cables' ends stay together.
        """
        hessian, motion = np.zeros((2 * links, 2 * links)), []
        for k, length in enumerate(self.lengths):
            step = length / links
            middle = (np.arange(links) + 0.5) / links
            alpha = np.interp(middle, self.t, self.shape(z, k)[0])
            h, v = self.forces(z)[[0, 1 + k]]
            bending = 2 * np.eye(links) - np.eye(links, k=1) - np.eye(links, k=-1)
            bending[0, 0] = bending[-1, -1] = 1
            tension = h * np.cos(alpha) + (Q * middle * length - v) * np.sin(alpha)
            block = slice(k * links, (k + 1) * links)
            hessian[block, block] = bending * self.ei / step + np.diag(tension * step)
            motion.append(step * np.vstack([-np.sin(alpha), SIDE[k] * np.cos(alpha)]))
        free = np.linalg.svd(np.hstack(motion))[2][2:]
        return int((np.linalg.eigvalsh(free @ hessian @ free.T) < 0).sum())
