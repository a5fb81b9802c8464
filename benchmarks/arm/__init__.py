"""One arm with seven joints in space: our C beside CasADi's and Pinocchio."""
