"""Inside test for meshes."""

from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

# Faces whose plane contains the point contribute no angle; relative to the product of the three lengths.
COPLANAR = 1e-12


@dataclass(frozen=True)
class Mesh:
    """The triangles of a mesh in its own frame: shape (faces, 3 corners, 3 coordinates), and its bounds."""

    triangles: NDArray[np.float64]
    low: NDArray[np.float64]
    high: NDArray[np.float64]

    @staticmethod
    def of(model: mujoco.MjModel, mesh: int) -> "Mesh":
        """The triangles of a model's mesh."""
        faces = model.mesh_face[model.mesh_faceadr[mesh] :][: model.mesh_facenum[mesh]]
        vertices = model.mesh_vert[model.mesh_vertadr[mesh] :][: model.mesh_vertnum[mesh]].astype(np.float64)
        return Mesh(vertices[faces], vertices.min(axis=0), vertices.max(axis=0))

    def depth(self, point: NDArray[np.float64]) -> float:
        """1 if a point lies inside, -1 if outside, 0 if on the surface, by the winding number around it.

        The solid angle of a triangle is that of van Oosterom and Strackee (1983). Unlike counting ray crossings, the
        sum is robust where a ray would hit an edge.
        """
        if bool((point < self.low).any()) or bool((point > self.high).any()):
            return -1.0
        to = self.triangles - point
        length = np.linalg.norm(to, axis=2)
        a, b, c = to[:, 0], to[:, 1], to[:, 2]
        la, lb, lc = length[:, 0], length[:, 1], length[:, 2]
        volume = np.einsum("ij,ij->i", a, np.cross(b, c))
        denominator = (
            la * lb * lc
            + np.einsum("ij,ij->i", a, b) * lc
            + np.einsum("ij,ij->i", b, c) * la
            + np.einsum("ij,ij->i", c, a) * lb
        )
        angle = np.where(np.abs(volume) <= COPLANAR * la * lb * lc, 0.0, 2.0 * np.arctan2(volume, denominator))
        # Inside 1 (or -1 for inverted faces), outside 0, on a face 0.5.
        winding = abs(float(angle.sum())) / (4.0 * np.pi)
        return 0.0 if abs(winding - 0.5) < 1e-6 else float(np.sign(winding - 0.5))
