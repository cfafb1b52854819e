import rover
