/* annual_figure.c - see annual_figure.h. */
#include "reports/annual/annual_figure.h"

#include <math.h>

#include "reports/parts/json.h"

bool pp_annual_figure_json(struct json_object *object, const char *key,
                           const struct pp_annual_value *figure, double unit,
                           const char *why)
{
    struct json_object *line = json_object_new_object();
    if (!pp_json_add(object, key, line))
        return false;
    pp_json_on_one_line(line);
    if (!isfinite(unit * figure->value))
        return pp_json_number(line, "value", NAN) && pp_json_text(line, "why", why);
    return pp_json_number(line, "value", unit * figure->value)
           && pp_json_number(line, "se", unit * figure->std_error);
}
