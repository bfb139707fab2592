"""What vectors are given as."""
from typing import Sequence, Union

import numpy as np

Vector = Union[Sequence[float], np.ndarray]  # of numbers; quaternions are x, y, z, w
