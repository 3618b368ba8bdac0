page-budget = Budget
