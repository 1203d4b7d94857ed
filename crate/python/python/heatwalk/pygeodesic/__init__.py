"""The names, arguments and answers of pygeodesic: `import heatwalk.pygeodesic.geodesic as geodesic`."""

from heatwalk.pygeodesic import geodesic

__all__ = ["geodesic"]
