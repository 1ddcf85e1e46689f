/* How libFuzzer changes a database beside changing bytes, nearly all of which SQLite sees and refuses: by SQL, so that the file stays sound and
 * what it says does not. Not used in replaying. */
#ifndef RL_TESTS_FUZZ_MERGE_MUTATE_H
#define RL_TESTS_FUZZ_MERGE_MUTATE_H

#include <sqlite3.h>

#include "fuzz/harness.h"

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t max_size) __attribute__((weak));
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max_size, unsigned seed);

static const char *const mutate_values[] = {
    "NULL",
    "0",
    "-1",
    "1",
    "2147483647",
    "-2147483648",
    "9223372036854775807",
    "0.5",
    "1e308",
    "1e999",
    "''",
    "'ok'",
    "'failed'",
    "'samples'",
    "x'00ff'",
    "hex(randomblob(40))",
    "hex(randomblob(700))",
    "'a' || char(9, 10, 13, 27) || 'b'",
    "'%s%n'",
    "'2026-01-31T12:00:00Z'",
    "'samples=1'",
    "'0123456789abcdef'",
};

static const struct {
    const char *name, *column[16];
} mutate_tables[] = {
    {"provenance",
     {"id", "environment", "version", "commit_id", "dirty", "code_hash", "cpu", "threads", "renderer",
      "time"}},
    {"runs", {"id", "study", "grid", "started", "provenance"}},
    {"run_cases",
     {"run", "position", "group_number", "identity", "scene", "scene_path", "scene_hash", "parameters"}},
    {"cases",
     {"id", "identity", "study", "scene", "scene_hash", "parameters", "status", "message", "seconds",
      "finished", "provenance"}},
    {"metrics", {"case_id", "position", "name", "value", "low", "high", "unit"}},
    {"samples", {"case_id", "series", "position", "value"}},
};

/* Other tables, and what runs of itself. */
static const char *const mutate_schema[] = {
    "PRAGMA user_version = 2",
    "PRAGMA writable_schema = ON; UPDATE sqlite_schema SET sql = replace(sql, ' NOT NULL', '')",
    "PRAGMA writable_schema = ON; UPDATE sqlite_schema SET sql = replace(sql, 'INTEGER PRIMARY KEY', 'TEXT')",
    "ALTER TABLE cases ADD COLUMN extra TEXT",
    "ALTER TABLE metrics RENAME TO other; CREATE VIEW metrics AS SELECT * FROM other",
    "CREATE VIEW other AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT 1 FROM n) SELECT i FROM n",
    "CREATE TRIGGER again AFTER INSERT ON cases BEGIN UPDATE cases SET seconds = 'x'; END",
    "CREATE TRIGGER gone BEFORE INSERT ON runs BEGIN DELETE FROM cases; END",
    "DROP TABLE samples",
    "CREATE UNIQUE INDEX one ON runs(study)",
};

#define MUTATE_PICK(list) ((unsigned)rand_r(seed) % (sizeof(list) / sizeof *(list)))

static inline void mutate_sql(sqlite3 *db, unsigned *seed)
{
    size_t t = MUTATE_PICK(mutate_tables), n = 0;
    const char *table = mutate_tables[t].name;
    while (n < 16 && mutate_tables[t].column[n])
        n++;
    const char *column = mutate_tables[t].column[(unsigned)rand_r(seed) % n];
    const char *key = mutate_tables[t].column[(unsigned)rand_r(seed) % n];
    const char *value = mutate_values[MUTATE_PICK(mutate_values)];
    unsigned row = (unsigned)rand_r(seed) % 4;
    char *sql = NULL;
    switch ((unsigned)rand_r(seed) % 8) {
    case 0:
        sql = sqlite3_mprintf("DELETE FROM %s WHERE %s = (SELECT %s FROM %s LIMIT 1 OFFSET %u)", table, key,
                              key, table, row);
        break;
    case 1:
        sql = sqlite3_mprintf("UPDATE OR IGNORE %s SET %s = %s", table, column, value);
        break;
    case 2:
        sql = sqlite3_mprintf("%s", mutate_schema[MUTATE_PICK(mutate_schema)]);
        break;
    case 3: /* another row's value */
        sql = sqlite3_mprintf("UPDATE OR IGNORE %s SET %s = (SELECT %s FROM %s LIMIT 1 OFFSET %u)", table,
                              column, column, table, row);
        break;
    default:
        sql = sqlite3_mprintf(
            "UPDATE OR IGNORE %s SET %s = %s WHERE %s = (SELECT %s FROM %s LIMIT 1 OFFSET %u)", table, column,
            value, key, key, table, row);
    }
    sqlite3_exec(db, sql, NULL, NULL, NULL);
    sqlite3_free(sql);
}

/* 0: it is no database that SQLite takes, or has become too large. */
static inline size_t mutate_database(uint8_t *data, size_t size, size_t max_size, unsigned *seed)
{
    sqlite3 *db = NULL;
    size_t result = 0;
    unsigned char *copy = sqlite3_malloc64(size ? size : 1);
    FUZZ_CHECK(copy && sqlite3_open(":memory:", &db) == SQLITE_OK);
    memcpy(copy, data, size);
    if (sqlite3_deserialize(db, "main", copy, (sqlite3_int64)size, (sqlite3_int64)size,
                            SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_RESIZEABLE) == SQLITE_OK) {
        for (unsigned i = 0; i < 1 + (unsigned)rand_r(seed) % 3; i++)
            mutate_sql(db, seed);
        sqlite3_int64 grown = 0;
        unsigned char *out = sqlite3_serialize(db, "main", &grown, 0);
        if (out && grown > 0 && (size_t)grown <= max_size) {
            memcpy(data, out, (size_t)grown);
            result = (size_t)grown;
        }
        sqlite3_free(out);
    }
    sqlite3_close(db);
    return result;
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max_size, unsigned seed)
{
    size_t changed = rand_r(&seed) % 4 ? mutate_database(data, size, max_size, &seed) : 0;
    return changed ? changed : LLVMFuzzerMutate(data, size, max_size);
}

#endif
