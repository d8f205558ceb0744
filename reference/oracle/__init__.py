"""An independent implementation of the trunk's equations, in numpy. Shares no code with libtrunk.

Arrays of vectors have the component first: positions are [xyz, particles], in m. SI units throughout.
"""

VERSION = 2  # of the equations; count on when trajectories change
