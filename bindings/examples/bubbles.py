# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: BSD-3-Clause
import numpy as np
import pcm

bubble = pcm.Surface.read("meshes/surfaces/bubble.obj")
pairing = pcm.Pairing(bubble, bubble, pcm.ContactLaw(stiffness=5.9e5), mode="both")
A = np.array([[1, 0, 0], [0, 0.96, -0.28], [0, 0.28, 0.96]])
contact = pairing.evaluate(A, r=[0.16, 0.02, 0.01])
print("force on E: {:g} {:g} {:g} N".format(*contact.force_Me))

r = np.column_stack([np.linspace(0.16, 0.12, 1000), np.full(1000, 0.02), np.full(1000, 0.01)])
answers = pairing.evaluate_many(np.broadcast_to(A, (1000, 3, 3)), r, threads=2)
print(f"{answers['touching'].sum()} of 1000 poses touch; the deepest: {answers['max_penetration'].max():g} m")
