/* xml_text.c - see xml_text.h. */
#include "model/base/xml_text.h"

#include <libxml/encoding.h>
#include <libxml/tree.h>
#include <string.h>
#include <strings.h>

#include "model/base/text.h"

static const char mark[] = "\xEF\xBB\xBF"; /* UTF-8 byte order mark */

void pp_xml_text_clear(struct pp_xml_text *text)
{
    if (text->converted)
        xmlFree(text->converted);
    *text = (struct pp_xml_text){0};
}

int pp_xml_text_line(const struct pp_xml_text *text, const char *at)
{
    int line = 1;
    for (const char *p = text->bytes; p < at; p++)
        line += *p == '\n';
    return line;
}

static bool starts(const char *p, const char *end, const char *with, size_t length)
{
    return (size_t)(end - p) >= length && memcmp(p, with, length) == 0;
}

static const char *find_text(const char *p, const char *end, const char *what)
{
    return memmem(p, (size_t)(end - p), what, strlen(what));
}

/* ---- the encoding ---- */

/* Reads the encoding from the declaration <?xml ... encoding="NAME"?> at p; name is
 * empty if there is none. Returns its position. */
static const char *declared(char *name, size_t room, const char *p, const char *end)
{
    name[0] = '\0';
    const char *close = starts(p, end, "<?xml", 5) ? find_text(p, end, "?>") : NULL;
    const char *at = close ? find_text(p, close, "encoding") : NULL;
    if (!at)
        return p;
    at += strlen("encoding");
    while (at < close && (*at == '=' || pp_text_is_white(*at)))
        at++;
    if (*at != '"' && *at != '\'')
        return at; /* the parser will reject it */
    const char *quote = memchr(at + 1, *at, (size_t)(close - at - 1));
    if (quote)
        pp_text_append(name, room, "%.*s", (int)(quote - at - 1), at + 1);
    return at + 1;
}

/* "UTF-16LE" or "UTF-16BE" if the text begins with the byte order mark of that encoding
 * or with <? in it; NULL: another encoding. */
static const char *utf16_name(const char *p, const char *end)
{
    if (starts(p, end, "\xFF\xFE", 2) || starts(p, end, "<\0?", 4))
        return "UTF-16LE";
    if (starts(p, end, "\xFE\xFF", 2) || starts(p, end, "\0<\0?", 4))
        return "UTF-16BE";
    return NULL;
}

/* Converts the text to UTF-8. If that is not possible, clears the text and notes a
 * mistake. */
static enum pp_status convert(struct pp_xml_text *text, const char *name,
                              struct pp_mistakes *mistakes, struct pp_error *err)
{
    char shown[64];
    xmlCharEncodingHandlerPtr handler = xmlFindCharEncodingHandler(name);
    pp_text_excerpt(shown, sizeof shown, name);
    if (!handler) {
        pp_mistakes_add(mistakes, 1,
                        "the encoding \"%s\" is unknown; save the file as UTF-8",
                        shown);
        pp_xml_text_clear(text);
        return PP_OK;
    }
    /* No encoding needs more than three bytes of UTF-8 for one of its own bytes. */
    xmlBufferPtr in = xmlBufferCreateStatic((void *)text->bytes, text->length);
    xmlBufferPtr out = xmlBufferCreateSize(3 * text->length + 64);
    bool has_memory = in && out;
    if (has_memory) {
        while (xmlBufferLength(in) > 0 && xmlCharEncInFunc(handler, out, in) > 0)
            ;
        text->length = (size_t)xmlBufferLength(out);
        text->bytes = text->converted = (char *)xmlBufferDetach(out);
        if (xmlBufferLength(in) > 0) {
            pp_mistakes_add(mistakes,
                            pp_xml_text_line(text, text->bytes + text->length),
                            "some bytes are not %s, the encoding of the file; the file "
                            "is damaged or incomplete; save it as UTF-8",
                            shown);
            pp_xml_text_clear(text);
        }
    }
    xmlBufferFree(in);
    xmlBufferFree(out);
    xmlCharEncCloseFunc(handler);
    return has_memory ? PP_OK : pp_fail_memory(err);
}

static enum pp_status make_utf8(struct pp_xml_text *text,
                                const struct pp_xml_format *format,
                                struct pp_mistakes *mistakes, struct pp_error *err)
{
    char name[64], shown[64];
    const char *p = text->bytes, *end = p + text->length;
    bool is_marked = starts(p, end, mark, 3);
    const char *utf16 = utf16_name(p, end);
    const char *at = declared(name, sizeof name, is_marked ? p + 3 : p, end);
    if (utf16 && !format->attributes_only)
        return convert(text, utf16, mistakes, err);
    if (utf16)
        pp_mistakes_add(mistakes, 1, "the file is UTF-16; save it as UTF-8");
    else if (!name[0] || strcasecmp(name, "UTF-8") == 0)
        return PP_OK;
    else if (format->attributes_only)
        pp_mistakes_add(mistakes, pp_xml_text_line(text, at),
                        "the encoding of the file is \"%s\"; expected UTF-8",
                        pp_text_excerpt(shown, sizeof shown, name));
    else if (is_marked || strncasecmp(name, "UTF-16", 6) == 0)
        return PP_OK;
    else
        return convert(text, name, mistakes, err);
    pp_xml_text_clear(text);
    return PP_OK;
}

/* ---- checks of the text ---- */

static bool is_not_empty(const struct pp_xml_text *text,
                         const struct pp_xml_format *format,
                         struct pp_mistakes *mistakes)
{
    const char *p = text->bytes, *end = p + text->length;
    p += starts(p, end, mark, 3) ? 3 : 0;
    while (p < end && pp_text_is_white(*p))
        p++;
    if (p == end)
        pp_mistakes_add(mistakes, 1, "the file is empty; expected %s", format->roots);
    else if (starts(p, end, mark, 3))
        pp_mistakes_add(
            mistakes, 1,
            "there is a second byte order mark; expected at most one, then %s",
            format->roots);
    else
        return true;
    return false;
}

static bool letters_are_sound(const struct pp_xml_text *text,
                              const struct pp_xml_format *format,
                              struct pp_mistakes *mistakes)
{
    const char *end = text->bytes + text->length;
    int bytes;
    for (const char *p = text->bytes; p < end; p += bytes) {
        bytes = pp_text_letter(p, (size_t)(end - p), NULL);
        if (bytes == 0)
            pp_mistakes_add(mistakes, pp_xml_text_line(text, p),
                            "byte 0x%02X is not UTF-8; save the file as UTF-8",
                            (unsigned)(unsigned char)*p);
        else if (*p == '\0')
            pp_mistakes_add(mistakes, pp_xml_text_line(text, p),
                            "there is a NUL byte; expected plain text in a %s",
                            format->file);
        else
            continue;
        return false;
    }
    return true;
}

/* Position after the > of the tag at p; NULL: the tag has no end. */
static const char *tag_end(const char *p, const char *end)
{
    char quote = '\0';
    for (; p < end; p++) {
        if (quote)
            quote = *p == quote ? '\0' : quote;
        else if (*p == '"' || *p == '\'')
            quote = *p;
        else if (*p == '>')
            return p + 1;
    }
    return NULL;
}

/* Position after the comment, CDATA section, processing instruction or tag at p; NULL:
 * it has no end. */
static const char *markup_end(const char *p, const char *end, bool *is_tag)
{
    static const char *const skipped[][2] = {
        {"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}};
    *is_tag = false;
    for (int i = 0; i < 3; i++) {
        size_t length = strlen(skipped[i][0]);
        if (starts(p, end, skipped[i][0], length)) {
            const char *close = find_text(p + length, end, skipped[i][1]);
            return close ? close + strlen(skipped[i][1]) : NULL;
        }
    }
    *is_tag = true;
    return tag_end(p, end);
}

/* Checks the length of all tags; also sets text->unended. */
static bool tags_are_short(struct pp_xml_text *text, struct pp_mistakes *mistakes)
{
    const char *p = text->bytes, *end = p + text->length;
    while (!text->unended && (p = memchr(p, '<', (size_t)(end - p)))) {
        bool is_tag;
        const char *next = markup_end(p, end, &is_tag);
        if (is_tag && (next ? next : end) - p > PP_XML_TAG_BYTES_MOST) {
            pp_mistakes_add(mistakes, pp_xml_text_line(text, p),
                            "a tag of more than %d bytes starts here; a quotation mark "
                            "or a > may be missing",
                            PP_XML_TAG_BYTES_MOST);
            return false;
        }
        text->unended = next ? NULL : p;
        p = next;
    }
    return true;
}

enum pp_status pp_xml_text_read(struct pp_xml_text *text, const char *bytes,
                                size_t length, const struct pp_xml_format *format,
                                struct pp_mistakes *mistakes, struct pp_error *err)
{
    *text = (struct pp_xml_text){.bytes = length ? bytes : "", .length = length};
    if (length > format->bytes_most) {
        pp_mistakes_add(mistakes, 0,
                        "the file is larger than %zu MiB; expected a smaller file",
                        format->bytes_most >> 20);
        pp_xml_text_clear(text);
        return PP_OK;
    }
    enum pp_status status = make_utf8(text, format, mistakes, err);
    if (status != PP_OK || !text->bytes || !is_not_empty(text, format, mistakes)
        || !letters_are_sound(text, format, mistakes)
        || !tags_are_short(text, mistakes))
        pp_xml_text_clear(text);
    return status;
}
