"""The names, arguments and answers of pygeodesic: `import heatwalk.pygeodesic.geodesic as geodesic`."""

from heatwalk._heatwalk import __version__
from heatwalk.pygeodesic import geodesic

__all__ = ["__version__", "geodesic"]
