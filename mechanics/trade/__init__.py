"""The trade of speed for accuracy, measured on a system and its values."""

from mechanics.trade.choice import Choice, Variant
from mechanics.trade.measure import Measurement
from mechanics.trade.recommend import Recommendation
from mechanics.trade.result import Trade
from mechanics.trade.run import trade

__all__ = ["Choice", "Measurement", "Recommendation", "Trade", "Variant", "trade"]
