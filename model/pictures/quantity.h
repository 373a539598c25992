/* quantity.h - the quantities that pixels may hold, and the units they are read in. */
#ifndef PP_MODEL_PICTURES_QUANTITY_H
#define PP_MODEL_PICTURES_QUANTITY_H

/* Lumens to a watt of the light in pictures, by convention of their format [WS98]. */
#define PP_LUMENS_PER_WATT 179.0

enum pp_quantity {
    PP_LUMINANCE,       /* pixels are radiances, W/sr/m2; read in cd/m2 */
    PP_ILLUMINANCE,     /* irradiances of the surface seen, W/m2; read in lx */
    PP_DAYLIGHT_FACTOR, /* of the surface seen, fractions; read in per cent */
    PP_QUANTITY_COUNT,
};

struct pp_quantity_words {
    const char *name;    /* as typed, and in the head of a picture: "luminance" */
    const char *heading; /* "Luminance" */
    const char *unit;    /* "cd/m²" */
    double scale;        /* from a pixel's number to that unit */
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
