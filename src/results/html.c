/* Elements of HTML, escaped, and the page's frame (see html.h). */
#include "results/html.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

void rl_html_text(struct rl_buffer *page, const char *text)
{
    for (; *text; text++) {
        switch (*text) {
        case '&':
            rl_buffer_add(page, "&amp;");
            break;
        case '<':
            rl_buffer_add(page, "&lt;");
            break;
        case '>':
            rl_buffer_add(page, "&gt;");
            break;
        case '"':
            rl_buffer_add(page, "&quot;");
            break;
        case '\'':
            rl_buffer_add(page, "&#39;");
            break;
        default:
            rl_buffer_printf(page, "%c", *text);
        }
    }
}

void rl_html_name(char name[], size_t size, const char *text)
{
    size_t n = 0;
    for (; *text && n + 4 < size; text++) {
        if (isalnum((unsigned char)*text) || strchr("._-", *text))
            name[n++] = *text;
        else
            n += (size_t)snprintf(name + n, size - n, "_%02x", (unsigned char)*text);
    }
    name[n] = '\0';
}

void rl_html_element(struct rl_buffer *page, const char *tag, const char *text)
{
    rl_buffer_printf(page, "<%s>", tag);
    rl_html_text(page, text);
    rl_buffer_printf(page, "</%s>\n", tag);
}

void rl_html_begin(struct rl_buffer *page, const char *title)
{
    rl_buffer_add(page, "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n");
    rl_html_element(page, "title", title);
    rl_buffer_printf(page, "<style>\n%s%s</style>\n</head>\n<body>\n", rl_html_style,
                     rl_html_style_of_claims);
}

void rl_html_end(struct rl_buffer *page)
{
    rl_buffer_add(page, "</body>\n</html>\n");
}

void rl_html_figure(struct rl_buffer *page, const char *source, const char *alternative, const char *caption,
                    const struct rl_html_link *links)
{
    rl_buffer_add(page, "<figure><img src=\"");
    rl_html_text(page, source);
    rl_buffer_add(page, "\" alt=\"");
    rl_html_text(page, alternative);
    rl_buffer_add(page, "\"><figcaption>");
    rl_html_text(page, caption);
    for (; links && links->label; links++) {
        rl_buffer_add(page, " <a href=\"");
        rl_html_text(page, links->href);
        rl_buffer_add(page, "\">");
        rl_html_text(page, links->label);
        rl_buffer_add(page, "</a>");
    }
    rl_buffer_add(page, "</figcaption></figure>\n");
}
