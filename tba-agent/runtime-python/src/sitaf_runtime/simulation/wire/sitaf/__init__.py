"""The wire's messages, in folders as protoc lays them out."""
