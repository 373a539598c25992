/* quantity.h - the quantities of pixels, and their printed units. */
#ifndef PP_MODEL_PICTURES_QUANTITY_H
#define PP_MODEL_PICTURES_QUANTITY_H

/* Luminous efficacy of the light in pictures (lm/W), fixed by the format [WS98]. */
#define PP_LUMENS_PER_WATT 179.0

enum pp_quantity {
    PP_LUMINANCE,       /* radiance, W/sr/m2; printed in cd/m2 */
    PP_ILLUMINANCE,     /* irradiance of the visible surface, W/m2; printed in lx */
    PP_DAYLIGHT_FACTOR, /* daylight factor of the visible surface, a fraction;
                         * printed in per cent */
    PP_QUANTITY_COUNT,
};

struct pp_quantity_words {
    const char *name;    /* as typed, and in the header of a picture: "luminance" */
    const char *heading; /* "Luminance" */
    const char *unit;    /* "cd/m²" */
    double scale;        /* printed units per unit of the pixels */
};

static inline struct pp_quantity_words pp_quantity_words(enum pp_quantity quantity)
{
    switch (quantity) {
    case PP_ILLUMINANCE:
        return (struct pp_quantity_words){"illuminance", "Illuminance", "lx",
                                          PP_LUMENS_PER_WATT};
    case PP_DAYLIGHT_FACTOR:
        return (struct pp_quantity_words){"df", "Daylight factor", "%", 100.0};
    case PP_LUMINANCE:
    case PP_QUANTITY_COUNT:
        break;
    }
    return (struct pp_quantity_words){"luminance", "Luminance", "cd/m²",
                                      PP_LUMENS_PER_WATT};
}

#endif
