/* annual_value.h - a result of an annual simulation with its standard error. */
#ifndef PP_MODEL_RESULTS_SHEETS_ANNUAL_VALUE_H
#define PP_MODEL_RESULTS_SHEETS_ANNUAL_VALUE_H

/* std_error is 0 if nothing was sampled. */
struct pp_annual_value {
    double value, std_error;
};

#endif
