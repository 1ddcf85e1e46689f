/* Pages of HTML as text: everything that comes from outside is escaped on its way in.
 *
 *     rl_html_begin(&page, "roughlight: report");
 *     rl_html_element(&page, "p", "RMSE < 1/255 & falling");      <p>RMSE &lt; 1/255 &amp; falling</p>
 *     rl_html_end(&page);
 *
 * A page stands alone: its style is inside, images are files beside it with relative links, there is no script.
 */
#ifndef RL_RESULTS_HTML_H
#define RL_RESULTS_HTML_H

#include "results/buffer.h"

/* Text as it stands between tags or inside a quoted attribute. */
void rl_html_text(struct rl_buffer *page, const char *text);

/* Text as a file's name, an anchor or a part of a link, where it needs no more escaping: letters, digits and ._- stay, all else becomes
 * its bytes in hexadecimal, "_20". */
void rl_html_name(char name[], size_t size, const char *text);

/* <tag>text</tag> */
void rl_html_element(struct rl_buffer *page, const char *tag, const char *text);

/* What rl_html_begin puts between <style> and </style>: for all pages, and for claims, pictures, and print. Two, since compilers need
 * not take a text of more than 4095 bytes. */
extern const char rl_html_style[], rl_html_style_of_claims[];

void rl_html_begin(struct rl_buffer *page, const char *title);
void rl_html_end(struct rl_buffer *page);

struct rl_html_link {
    const char *label, *href;
};

/* An image with its caption and, under it, links to its other forms (an array that ends with a NULL label, or NULL).
 * `alternative` says what it shows to those who cannot see it. */
void rl_html_figure(struct rl_buffer *page, const char *source, const char *alternative, const char *caption,
                    const struct rl_html_link *links);

#endif
